#pragma once

#include <cstdint>
#include <memory>
#include <new>

#include "bullet/batch/bullet_rows.h"
#include "bullet/batch/driven_lanes.h"
#include "bullet/batch/effective_inertia.h"
#include "bullet/body/non_finite.h"
#include "polhode/bullet/rotation_control.h"
#include "scheme_base/wide_scheme.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

inline constexpr std::size_t kIncidentKinds = 3;

/// The free step of a body with locked axes, as it is given to the solver.
struct HeldTurn {
  Vector3 velocity_W;
  Matrix3 momentum_W;       ///< maps a change of velocity to a change of momentum, kg m^2
  Matrix3 inverse_W;        ///< inverse of momentum_W
  bool is_effective;        ///< momentum_W is the effective inertia, not the plain one
  bool is_resolved = true;  ///< false: dt is too long to resolve the gyroscopic motion
  // The part of the torque law and the motors, evaluated at the start of the step.
  Vector3 driven_W = Vector3::Zero();  ///< part of velocity_W
  Vector3 gain_W = Vector3::Zero();    ///< change of L_W
  Vector3 rotor_end_B = Vector3::Zero();
};

/// Up to eight bodies of one scheme, side by side. Lane i of every member belongs to body i; a lane without a
/// body is a hole. All numbers are double, except for the values that the library last wrote to Bullet's
/// bodies.
struct alignas(64) Batch {
  /// is_driven: true if each body has a Drive.
  Batch(SchemePointer scheme_of_all, bool is_driven);

  // The scheme.
  SchemePointer scheme;
  const WideScheme* wide_scheme;  ///< the scheme, if it steps eight bodies at once; else null
  TurnVelocity turn_velocity;
  bool keeps_rotation;  ///< false: R_WB is stored beside q_WB

  // The bodies.
  std::array<btRigidBody*, kLanes> bodies{};       ///< null in a hole
  std::array<int, kLanes> identities{};            ///< body_identity
  std::array<std::uint32_t, kLanes> list_index{};  ///< in the world's list of bodies
  LaneBits diverged;                               ///< left to Bullet, at rest in the last finite state
  std::unique_ptr<DrivenLanes> driven;             ///< null: the bodies have no Drive
  LaneBits state_was_set;  ///< set by set_rotation or restore: the first step starts from this state

  // Within a step.
  LaneBits begun;                         ///< lanes whose step has begun
  LaneBits in_solve;                      ///< lanes of `begun` between before_solve and after_solve
  LaneBits torqued;                       ///< lanes of `begun` with a torque on the body
  LaneBits may_be_clamped;                ///< continuous collision detection may stop these; set by predict
  LaneBits of_library;                    ///< lanes that Bullet's loop skips in the present stage
  LaneBits constrained;                   ///< lanes in a joint or a contact
  LaneBits held;                          ///< lanes with locked axes
  bool has_replaced_bodies = false;       ///< a body was replaced by another at the same address
  std::array<int, kLanes> world_index{};  ///< btCollisionObject::getWorldArrayIndex at the start of the step

  // Values given to the solver for constrained lanes.
  LaneBits given_mean;       ///< the mean velocity of the free step
  LaneBits given_effective;  ///< the effective inertia as well
  LaneBits given_torque;     ///< the gyroscopic change of a scheme that carries omega, as a torque
  LaneBits unresolved;       ///< omega only: dt is too long to resolve the gyroscopic motion
  std::array<std::uint8_t, kLanes> gyroscopic_flags{};  ///< the application's flags, cleared during the solve
  std::unique_ptr<BulletRows> applied_torque_W;  ///< the application's torques of given_torque; null at first
  std::unique_ptr<EffectiveInertia<Wide>> effective;         ///< for given_mean; null at first
  std::unique_ptr<std::array<HeldTurn, kLanes>> held_turns;  ///< for held; null at first

  // Counts and incidents.
  std::array<std::uint64_t, kLanes> steps{};
  std::array<std::uint32_t, kLanes> unresolved_steps{};
  std::array<LaneBits, kIncidentKinds> to_report{};  ///< lanes with a new incident, by IncidentKind
  std::array<LaneBits, kIncidentKinds> reported{};   ///< lanes whose incident was reported to the handler

  // The state.
  std::unique_ptr<Matrix3Wide> R_WB;  ///< null if the scheme keeps a rotation
  std::unique_ptr<Wide[]> memory;     ///< the scheme's memory
  QuaternionWide q_WB;
  Vector3Wide omega_W;
  Vector3Wide L_W;

  // The values that the library last wrote to Bullet's bodies; the pose is q_WB, rounded. Always finite.
  BulletRows written_omega_W;
  BulletRows inverse_inertia_B;
  BulletRows origin;

  /// Returns true if the body was replaced by another one at the same address.
  bool is_replaced(std::size_t lane) const { return body_identity(*bodies[lane]) != identities[lane]; }
  std::size_t memory_rows() const { return wide_scheme != nullptr ? wide_scheme->memory_rows() : 0; }
  /// Puts a body into a hole, in its present motion. Values that are not finite count as rest at the origin.
  /// `drive` is null in a batch without driven lanes.
  void attach(std::size_t lane, btRigidBody& body, Drive* drive);
  /// Sets the state to the body's present motion, so that its first step starts there.
  void start(std::size_t lane);
  /// Sets the state's orientation and velocity, with the body's rotors and the matching momentum.
  void set_motion(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W);
  /// Restarts the lane from this motion, and writes it to the body, rounded.
  void set_rotation(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W);
  void detach(std::size_t lane);
  /// Leaves the body to Bullet for the rest of the present step.
  void leave_step(std::size_t lane);
  /// Moves a body here from a batch of the same scheme, with everything but its drive, which must already be
  /// set. If memory for the values given to the solver runs out, the rest of the present step omits
  /// these.
  void move_from(const Batch& other, std::size_t from, std::size_t to) noexcept;

  RotationState state(std::size_t lane) const;
  BodyMotion last_written(std::size_t lane) const;
  /// Sets the state and clears the scheme's memory of the lane.
  void set_state(std::size_t lane, const RotationState& state);
  /// Returns the state of all lanes, including those without a body.
  WideState wide_state() const;
  Vector3Wide inertia_B() const { return Vector3Wide(to_double(inverse_inertia_B).cwiseInverse()); }

  BodyRotation rotation(std::size_t lane) const;

  /// @name The scheme, for the given lanes
  /// A scheme that cannot step eight bodies at once is called lane by lane. Other lanes of `result` are
  /// undefined.
  /// @{
  /// Returns the input of a step without a kick.
  WideStepInput free_input(btScalar dt) const;
  /// Calls RotationScheme::step, including torque laws and motors. memory_or_null is the batch's memory, or
  /// null to take a step without it.
  void step(const LaneBits& lanes, const WideStepInput& input, WideState& result, Wide* memory_or_null) const;
  /// Does the same for one lane, without memory.
  void step(std::size_t lane, const StepInput& input, RotationState& state) const;
  /// Calls RotationScheme::turn.
  void turn(const LaneBits& lanes, const Vector3Wide& velocity_W, btScalar dt, WideState& result) const;
  /// @}

  /// Replaces values that are not finite by the last ones written, and notes the incident.
  void sanitize(std::size_t lane);

  void note(std::size_t lane, IncidentKind kind) { to_report[static_cast<std::size_t>(kind)].set(lane); }
  LaneBits lanes_with_incident() const { return to_report[0] | to_report[1] | to_report[2]; }
};

/// Returns the object, created if needed, or null if memory runs out. A step then does without it.
template <class Object>
Object* make_if_null(std::unique_ptr<Object>& object) noexcept {
  if (object == nullptr) object.reset(new (std::nothrow) Object());
  return object.get();
}

/// Writes a pose, at the end of the step or interpolated, to the motion state of a moving body. If the
/// scheme's R_WB is not a rotation, writes R_WB instead, rotated from the end of the step to that pose.
void show(const Batch& batch, std::size_t lane, btRigidBody& body, btTransform pose);

/// Returns the bodies of the lanes, and `placeholder` for the other lanes.
BodyPointers body_pointers(const Batch& batch, const LaneBits& lanes, btRigidBody& placeholder);

/// Accesses one lane of gathered vectors.
inline btVector3 vector_in_lane(const BulletRows& rows, std::size_t lane) {
  return {rows.x[lane], rows.y[lane], rows.z[lane]};
}
inline void set_vector_in_lane(std::size_t lane, const btVector3& v, BulletRows& rows) {
  rows.x.set(lane, v.x());
  rows.y.set(lane, v.y());
  rows.z.set(lane, v.z());
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
