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

/// The free step of a body that may not turn freely, as the solver is told of it.
struct HeldTurn {
  Vector3 velocity_W;
  Matrix3 momentum_W;  ///< dL = momentum_W dv
  Matrix3 inverse_W;
  bool is_effective;        ///< not the plain inertia
  bool is_resolved = true;  ///< false: dt is too long to resolve the gyroscopic motion
  // What drives the body, taken at the start of the step.
  Vector3 driven_W = Vector3::Zero();  ///< its part of velocity_W
  Vector3 gain_W = Vector3::Zero();    ///< of L_W
  Vector3 rotor_end_B = Vector3::Zero();
};

/// Up to eight bodies of one scheme, side by side for as long as they stay. Lane i of every member is body i;
/// a lane without a body is a hole. Everything is double, except what Bullet's bodies held when the library
/// last wrote them.
struct alignas(64) Batch {
  /// is_driven: each body has a Drive.
  Batch(SchemePointer scheme_of_all, bool is_driven);

  // The scheme.
  SchemePointer scheme;
  const WideScheme* wide_scheme;  ///< the same, if it steps eight bodies at once
  TurnVelocity turn_velocity;
  bool keeps_rotation;  ///< false: R_WB is kept beside q_WB

  // The bodies.
  std::array<btRigidBody*, kLanes> bodies{};       ///< null in a hole
  std::array<int, kLanes> identities{};            ///< body_identity
  std::array<std::uint32_t, kLanes> list_index{};  ///< in the world's list of bodies
  LaneBits diverged;                               ///< left to Bullet, at rest in its last finite state
  std::unique_ptr<DrivenLanes> driven;             ///< null: none of the bodies has a Drive
  LaneBits state_was_set;  ///< by set_rotation or restore: the first step starts from it

  // Within a step.
  LaneBits begun;                         ///< lanes whose step has begun
  LaneBits in_solve;                      ///< of these, those between before_solve and after_solve
  LaneBits torqued;                       ///< of these, those whose body is under a torque
  LaneBits may_be_clamped;                ///< continuous collision detection may stop these; predict knows
  LaneBits of_library;                    ///< in the present stage Bullet's loop skips these
  LaneBits constrained;                   ///< in a joint or a contact
  LaneBits held;                          ///< may not turn freely about some axis
  bool has_replaced_bodies = false;       ///< another body has come to the address of one of these
  std::array<int, kLanes> world_index{};  ///< btCollisionObject::getWorldArrayIndex, as the step began

  // Given to the solver for constrained lanes.
  LaneBits given_mean;       ///< the mean velocity of their free step
  LaneBits given_effective;  ///< their effective inertia too
  LaneBits given_torque;     ///< the gyroscopic change of a scheme that carries omega, as a torque
  LaneBits unresolved;       ///< omega alone: dt is too long to resolve their gyroscopic motion
  std::array<std::uint8_t, kLanes> gyroscopic_flags{};  ///< the application's, which the solver has not
  std::unique_ptr<BulletRows> applied_torque_W;  ///< the application's, of lanes given_torque; null at first
  std::unique_ptr<EffectiveInertia<Wide>> effective;         ///< of lanes given_mean; null at first
  std::unique_ptr<std::array<HeldTurn, kLanes>> held_turns;  ///< of lanes held; null at first

  // Counts and incidents.
  std::array<std::uint64_t, kLanes> steps{};
  std::array<std::uint32_t, kLanes> unresolved_steps{};
  std::array<LaneBits, kIncidentKinds> to_report{};  ///< lanes of an incident, by IncidentKind
  std::array<LaneBits, kIncidentKinds> reported{};   ///< lanes whose incident the handler has heard of

  // The state.
  std::unique_ptr<Matrix3Wide> R_WB;  ///< only where the scheme does not keep a rotation
  std::unique_ptr<Wide[]> memory;     ///< of the scheme
  QuaternionWide q_WB;
  Vector3Wide omega_W;
  Vector3Wide L_W;

  // Bullet's bodies as the library last wrote them: the pose is q_WB, rounded. Always finite.
  BulletRows written_omega_W;
  BulletRows inverse_inertia_B;
  BulletRows origin;

  /// Returns whether another body has come to the address of this one.
  bool is_replaced(std::size_t lane) const { return body_identity(*bodies[lane]) != identities[lane]; }
  std::size_t memory_rows() const { return wide_scheme != nullptr ? wide_scheme->memory_rows() : 0; }
  /// Takes the body into a hole as it is; what is not finite is taken to be at rest in the origin. drive: null in a
  /// batch without driven lanes.
  void attach(std::size_t lane, btRigidBody& body, Drive* drive);
  /// Takes the body's motion as it is: its first step starts there, whenever the body was seen first.
  void start(std::size_t lane);
  /// Makes this the state, with the rotors that the body has and the momentum that goes with both.
  void set_motion(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W);
  /// Starts the lane afresh from these, and writes them to the body, rounded.
  void set_rotation(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W);
  void detach(std::size_t lane);
  /// Takes the body out of a step under way: Bullet has it for the rest.
  void leave_step(std::size_t lane);
  /// Takes over the body in another batch of the same scheme, with all that is known of it but for its drive, which
  /// it has already. Where there is no memory for what the solver was given, the rest of a step under way does without.
  void move_from(const Batch& other, std::size_t from, std::size_t to) noexcept;

  RotationState state(std::size_t lane) const;
  BodyMotion last_written(std::size_t lane) const;
  /// Sets the state, which nothing the scheme remembers of the lane belongs to.
  void set_state(std::size_t lane, const RotationState& state);
  /// All lanes, those without a body too.
  WideState wide_state() const;
  Vector3Wide inertia_B() const { return Vector3Wide(to_double(inverse_inertia_B).cwiseInverse()); }

  BodyRotation rotation(std::size_t lane) const;

  /// @name The scheme, for the lanes given A scheme that does not step eight bodies at once is called lane by
  /// lane. Other lanes of `result` are left undefined.
  /// @{
  /// Without a kick.
  WideStepInput free_input(btScalar dt) const;
  /// RotationScheme::step, with what drives the bodies. memory_or_null: the batch's, or nothing to remember.
  void step(const LaneBits& lanes, const WideStepInput& input, WideState& result, Wide* memory_or_null) const;
  /// The same for one lane, which remembers nothing.
  void step(std::size_t lane, const StepInput& input, RotationState& state) const;
  /// RotationScheme::turn.
  void turn(const LaneBits& lanes, const Vector3Wide& velocity_W, btScalar dt, WideState& result) const;
  /// @}

  /// Replaces what is not finite by what the library wrote last, and notes the incident.
  void sanitize(std::size_t lane);

  void note(std::size_t lane, IncidentKind kind) { to_report[static_cast<std::size_t>(kind)].set(lane); }
  LaneBits lanes_with_incident() const { return to_report[0] | to_report[1] | to_report[2]; }
};

/// Returns the object, made if there is none; null if there is no memory for one: a step does without then.
template <class Object>
Object* make_if_null(std::unique_ptr<Object>& object) noexcept {
  if (object == nullptr) object.reset(new (std::nothrow) Object());
  return object.get();
}

/// Hands the pose, at the end of the step or beside it, to the motion state of a body that moves. Where the
/// scheme's R_WB is no rotation, it is shown turned by as much.
void show(const Batch& batch, std::size_t lane, btRigidBody& body, btTransform pose);

/// The body of each of the lanes; `placeholder` in the others.
BodyPointers body_pointers(const Batch& batch, const LaneBits& lanes, btRigidBody& placeholder);

/// One lane of gathered vectors.
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
