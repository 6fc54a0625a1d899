#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "polhode/bullet/incident.h"
#include "polhode/bullet/precision.h"
#include "polhode/bullet/snapshot.h"
#include "polhode/scheme_registry.h"
#include "polhode/torque_law.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Holds the rotation of a body that the library rotates, in double precision.
struct BodyRotation {
  /// q_WB, R_WB, omega_W, L_W. In a joint or a contact L_W, and omega_W with it, runs half a step beside the
  /// velocity that the body shows.
  RotationState state;
  double energy_J = 0.0;    ///< rotational kinetic energy, of the body without its rotors
  std::uint64_t steps = 0;  ///< steps taken with the present scheme
  /// The steps of these that had no gyroscopic term: in a joint or a contact, with dt too long to resolve the
  /// body's gyroscopic motion there (take a shorter one).
  std::uint64_t unresolved_steps = 0;
  bool diverged = false;    ///< the scheme blew up: `state` is the last finite one, the body spins no more
  std::string_view scheme;  ///< the scheme's name; valid as long as the scheme
};

/// Who gives the rotors inside a body another angular momentum.
enum class RotorChange : std::uint8_t {
  by_motor,      ///< a motor inside the body: L_W stays, and the body's velocity changes
  from_outside,  ///< the body's velocity stays, and L_W changes
};

/// "by motor" or "from outside".
std::string_view to_string(RotorChange change);

/// What is set for a body: how it is rotated while it is dynamic and in the world.
struct BodySettings {
  SchemePointer scheme;         ///< null: Bullet rotates it
  bool has_own_choice = false;  ///< set by set_scheme or release; false: as the world's default says
  TorqueLaw torque_law;         ///< empty: none
  TorqueLawOrder torque_law_order = TorqueLawOrder::two;
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< kg m^2/s, at present
  Vector3 rotor_torque_B = Vector3::Zero();    ///< of the motors, N m
};

class WorldStepper;
class RotationPlugin;
template <class Base>
class RotationWorld;

/// Chooses which bodies of a world are rotated by which scheme, and reports their state. A RotationWorld and
/// a RotationPlugin each have one, `rotation()`.
///
/// A btMultiBody whose links, if it has any, are all fixed is a body too; one with links that move is
/// Bullet's. A multibody has no identity in Bullet: one that comes, between two steps, to the address of one
/// that went has its choice.
///
/// Every dynamic body has the world's default scheme unless it was told otherwise. A body's choice lasts
/// until it is absent from the world during a step; it survives being removed and added again between two
/// steps. Outside a step bodies are as the application left them: their gyroscopic flags are cleared within
/// the step only, so that the term does not count twice. Soft bodies push rigid ones when these have taken
/// their step: the next step takes it as a change by the application. Not thread-safe: call it from where you
/// call stepSimulation.
///
/// Out of memory: a function that throws std::bad_alloc has changed nothing. A step throws nothing and goes
/// on. Bodies that are new to it stay Bullet's until a later step finds the memory, and then start from their
/// present motion. A body in its first joint or contact may lack its gyroscopic term in that step. A scheme
/// of the application's must neither throw nor allocate in a step.
class RotationControl {
 public:
  ~RotationControl();
  RotationControl(const RotationControl&) = delete;
  RotationControl& operator=(const RotationControl&) = delete;

  /// @name Choosing a scheme
  /// Each throws std::logic_error if the world is gone.
  /// @{
  /// The scheme of every dynamic body that has none of its own; initially polhode::default_scheme().
  /// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or a null pointer, or if the
  /// scheme takes no rotors and a body with the default scheme has some.
  void set_default_scheme(std::string_view name);
  void set_default_scheme(SchemePointer scheme);
  /// Removes the default scheme: from now on the library rotates only bodies with a scheme of their own.
  void clear_default_scheme();
  /// Null if the world has none.
  SchemePointer default_scheme() const;

  /// Rotates the body by this scheme from the next step on, starting afresh from its present pose and
  /// velocity (a diverged body too). `body` may be a collider of a multibody.
  /// @throws std::invalid_argument for an unknown name, a null pointer, a static body, a multibody whose links
  /// move or whose base is fixed, or an object that is neither; for a scheme that takes no rotors if the body has some.
  void set_scheme(btCollisionObject& body, std::string_view name);
  void set_scheme(btCollisionObject& body, SchemePointer scheme);
  void set_scheme(btMultiBody& multibody, std::string_view name);
  void set_scheme(btMultiBody& multibody, SchemePointer scheme);
  /// Gives the body the world's default scheme again.
  void use_default_scheme(btCollisionObject& body);
  void use_default_scheme(btMultiBody& multibody);
  /// Gives the body back to Bullet, which rotates it again.
  void release(btCollisionObject& body);
  void release(btMultiBody& multibody);
  /// Returns what is set for the body, in the world or not, by the functions above and below.
  /// @throws std::invalid_argument as set_scheme, but static bodies have settings too.
  BodySettings settings_of(const btCollisionObject& body) const;
  BodySettings settings_of(const btMultiBody& multibody) const;
  /// @}

  /// @name What drives a body
  /// A law and rotors stay with the body as its scheme does, through another choice of scheme too; `release` forgets
  /// them. Each throws std::invalid_argument as set_scheme does, for a body that is not to be rotated by the library,
  /// and for numbers that are not finite.
  /// @{
  /// The torque of this law acts on the body from the next step on, beside what else does. If it fails, that is an
  /// incident, and the step goes on without it. About a locked axis of a body it has no effect; about the others it
  /// is then of order 1.
  /// @throws std::invalid_argument also for an empty function.
  void set_torque_law(btCollisionObject& body, TorqueLaw law, TorqueLawOrder order = TorqueLawOrder::two);
  void set_torque_law(btMultiBody& multibody, TorqueLaw law, TorqueLawOrder order = TorqueLawOrder::two);
  void clear_torque_law(btCollisionObject& body);
  void clear_torque_law(btMultiBody& multibody);
  /// Gives rotors inside the body this angular momentum (RotationState::rotor_momentum_B, kg m^2/s) at once.
  /// @throws std::invalid_argument also if the body's scheme does not take rotors; the message lists those that do.
  void set_rotor_momentum(btCollisionObject& body, const Vector3& rotor_momentum_B, RotorChange change);
  void set_rotor_momentum(btMultiBody& multibody, const Vector3& rotor_momentum_B, RotorChange change);
  /// Motors inside the body turn its rotors by this torque (N m, body axes) until it is set to 0: their momentum grows
  /// by it, and L_W stays.
  /// @throws std::invalid_argument as set_rotor_momentum.
  void set_rotor_torque(btCollisionObject& body, const Vector3& rotor_torque_B);
  void set_rotor_torque(btMultiBody& multibody, const Vector3& rotor_torque_B);
  /// The time of torque laws, s: that of the steps since this object was made, unless it was set.
  double time() const;
  void set_time(double time_s);
  /// @}

  /// Returns true if the library rotates this body: it is in the world, dynamic at present, and has a scheme.
  bool manages(const btRigidBody& body) const;
  bool manages(const btMultiBody& multibody) const;
  /// Returns the body's present rotation: the library's double state if the body is bit for bit as the last
  /// step left it, else the body's own values. A velocity whose momentum or energy is past the largest double
  /// counts as 0; in its next step such a body has diverged.
  /// @throws std::invalid_argument if the body is not managed.
  BodyRotation rotation_of(const btRigidBody& body) const;
  BodyRotation rotation_of(const btMultiBody& multibody) const;
  /// Returns how many bodies the library rotates, multibodies among them.
  std::size_t managed_bodies() const;
  /// Returns those bodies, in the order of the world's lists: what `manages` is true of.
  std::vector<btRigidBody*> managed_rigid_bodies() const;
  std::vector<btMultiBody*> managed_multibodies() const;

  /// Sets the double state of a managed body: its next step goes on from exactly these, where Bullet's
  /// setters would round them in a single-precision world. L_W follows, and R_WB is q_WB's matrix. Pose,
  /// interpolated pose and angular velocity of the body are written, rounded. A diverged body turns again.
  /// The body is not woken.
  /// @param q_WB of unit length; it is normalized if it is not
  /// @param omega_W rad/s
  /// @throws std::invalid_argument if the body is not managed, a number is not finite, q_WB is zero, or
  /// omega_W is faster than kMaximumAngularSpeed (rotation_limits.h).
  /// @throws std::logic_error within a step.
  void set_rotation(btRigidBody& body, const Quaternion& q_WB, const Vector3& omega_W);

  /// @name Snapshots snapshot.h says what they hold and how rollback, lockstep and replay use them. Each
  /// throws std::logic_error within a step, or while the plugin is detached. Restoring throws
  /// std::invalid_argument, having changed nothing, for a snapshot that is damaged, of another format
  /// version, of the other precision, not finite or of another body or world; the message says what is wrong
  /// and what is valid. Contact callbacks are not called. Motion states are written by the next step.
  /// @{ One body with its rotation: in free flight it takes the same steps, to the last bit, as the body that
  /// went on. Contact points belong to the world and are not in it. Multibodies cannot be saved.
  /// @throws std::invalid_argument if the body is not managed, or has a number that is not finite.
  Snapshot save(const btRigidBody& body) const;
  /// Chooses the scheme of the snapshot for the body, if it has another.
  void restore(btRigidBody& body, const Snapshot& snapshot);
  /// The whole world: all its bodies, also those that the library does not rotate, with contacts and joints.
  /// @throws std::invalid_argument if a number is not finite, if the world has multibodies or soft bodies, or
  /// another broadphase, pair cache or dispatcher than btDbvtBroadphase, btHashedOverlappingPairCache and
  /// btCollisionDispatcher.
  Snapshot save_world() const;
  /// Restores the world, whose bodies and joints are in the order in which they were saved, or in `order`:
  /// the lists of the world are then put in that order. If memory runs out, the world is left partly
  /// restored, and may be restored again.
  void restore_world(const Snapshot& snapshot);
  void restore_world(const Snapshot& snapshot, const WorldOrder& order);
  /// @}

  /// Replaces the handler; an empty one is allowed. Without a handler incidents are only counted.
  void set_incident_handler(IncidentHandler handler);
  /// Returns the number of incidents since the start, also those after a body's first.
  std::uint64_t incidents() const;

 private:
  friend class RotationPlugin;
  template <class Base>
  friend class RotationWorld;

  explicit RotationControl(btDynamicsWorld& world);

  // The stages of a step, see RotationWorld. `bullet` does what Bullet's class does in the stage.
  using BulletsStage = std::function<void()>;
  void predict_unconstrained_motion(btScalar dt, const BulletsStage& bullet);
  void create_predictive_contacts(btScalar dt, const BulletsStage& bullet);
  void before_solve() noexcept;
  void integrate_transforms(btScalar dt, const BulletsStage& bullet);
  void after_integration(btScalar dt) noexcept;
  void synchronize_motion_states(const BulletsStage& bullet);
  void show_swollen_bodies();

  std::unique_ptr<WorldStepper> stepper_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
