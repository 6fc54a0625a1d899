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

/// The rotation of a body that the library rotates, in double precision.
struct BodyRotation {
  /// q_WB, R_WB, omega_W, L_W. In a joint or a contact, L_W and omega_W are offset by half a step from the
  /// velocity that the btRigidBody holds.
  RotationState state;
  double energy_J = 0.0;    ///< rotational kinetic energy of the body without its rotors, J
  std::uint64_t steps = 0;  ///< number of steps taken with the present scheme
  /// Number of these steps that omitted the gyroscopic term: the body was in a joint or a contact, and dt was
  /// too long to resolve its gyroscopic motion there. Reduce dt to avoid such steps.
  std::uint64_t unresolved_steps = 0;
  bool diverged = false;    ///< the scheme diverged: `state` is the last finite one, and the body is at rest
  std::string_view scheme;  ///< name of the scheme; valid as long as the scheme
};

/// How the angular momentum of the rotors inside a body changes.
enum class RotorChange : std::uint8_t {
  by_motor,      ///< by a motor inside the body: L_W stays, and the body's velocity changes
  from_outside,  ///< from outside: the body's velocity stays, and L_W changes
};

/// Returns "by motor" or "from outside".
std::string_view to_string(RotorChange change);

/// The settings of a body. They apply while the body is dynamic and in the world.
struct BodySettings {
  SchemePointer scheme;         ///< null: Bullet rotates the body
  bool has_own_choice = false;  ///< set by set_scheme or release; false: uses the default scheme
  TorqueLaw torque_law;         ///< empty: no law
  TorqueLawOrder torque_law_order = TorqueLawOrder::two;
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< present value, kg m^2/s
  Vector3 rotor_torque_B = Vector3::Zero();    ///< torque of the motors on the rotors, N m
};

class WorldStepper;
class RotationPlugin;
template <class Base>
class RotationWorld;

/// Chooses which scheme rotates which body of a world, and reports the bodies' rotation. Each RotationWorld
/// and RotationPlugin has one, `rotation()`.
///
/// Bodies are rigid bodies and those btMultiBody objects that have no links or only fixed ones. Bullet keeps
/// moving multibodies with movable links. Bullet gives multibodies no identity: one that takes the address of
/// a deleted one between two steps inherits its settings.
///
/// Every dynamic body uses the world's default scheme unless it has its own. The settings of a body are kept
/// when it is removed from the world and added again between two steps, and dropped when it is absent during
/// a step. The gyroscopic flags of a body are cleared within a step only, so that the term does not count
/// twice. Soft bodies push rigid bodies after these have taken their step: the next step treats the push as a
/// change by the application. Not thread-safe: call from the thread that calls stepSimulation.
///
/// Out of memory: a function that throws std::bad_alloc has changed nothing. A step never throws. Bullet
/// keeps rotating new bodies until a later step can allocate memory for them; they then start from their
/// present motion. A body in its first joint or contact may lack its gyroscopic term in that step. A custom
/// scheme must neither throw nor allocate memory in a step.
class RotationControl {
 public:
  ~RotationControl();
  RotationControl(const RotationControl&) = delete;
  RotationControl& operator=(const RotationControl&) = delete;

  /// @name Schemes
  /// Functions that change a setting throw std::logic_error if the world is gone.
  /// @{
  /// Sets the scheme of all dynamic bodies that have no scheme of their own; initially
  /// polhode::default_scheme().
  /// @throws std::invalid_argument for an unknown name (the message lists the valid ones), for a null
  /// pointer, or if the scheme takes no rotors and a body that uses the default scheme has some.
  void set_default_scheme(std::string_view name);
  void set_default_scheme(SchemePointer scheme);
  /// Removes the default scheme: the library then rotates only bodies with a scheme of their own.
  void clear_default_scheme();
  /// Returns null if the world has no default scheme.
  SchemePointer default_scheme() const;

  /// Rotates the body by this scheme from the next step on. Starts from the body's present pose and velocity,
  /// even if the body had diverged. `body` may be a collider of a multibody.
  /// @throws std::invalid_argument for an unknown name, a null pointer, a static body, a multibody with
  /// movable links or a fixed base, another kind of object, or if the scheme takes no rotors and the body has
  /// some.
  void set_scheme(btCollisionObject& body, std::string_view name);
  void set_scheme(btCollisionObject& body, SchemePointer scheme);
  void set_scheme(btMultiBody& multibody, std::string_view name);
  void set_scheme(btMultiBody& multibody, SchemePointer scheme);
  /// Makes the body use the world's default scheme again. Throws as set_scheme, but accepts static bodies.
  void use_default_scheme(btCollisionObject& body);
  void use_default_scheme(btMultiBody& multibody);
  /// Returns the body to Bullet. Throws as set_scheme, but accepts static bodies.
  void release(btCollisionObject& body);
  void release(btMultiBody& multibody);
  /// Returns the settings of a body, whether or not the body is in the world.
  /// @throws std::invalid_argument as set_scheme, but accepts static bodies.
  BodySettings settings_of(const btCollisionObject& body) const;
  BodySettings settings_of(const btMultiBody& multibody) const;
  /// @}

  /// @name Torque laws and rotors
  /// A body keeps its torque law and rotors when its scheme changes; `release` drops them. The setters throw
  /// std::invalid_argument as set_scheme does, for a body that no scheme rotates, and for numbers that are
  /// not finite.
  /// @{
  /// Adds the torque of this law to the other torques on the body from the next step on. If the law fails,
  /// the step is taken without it and an incident is reported. A body with locked axes gets no torque about
  /// these, and its step with the law is of order 1.
  /// @throws std::invalid_argument also for an empty function.
  void set_torque_law(btCollisionObject& body, TorqueLaw law, TorqueLawOrder order = TorqueLawOrder::two);
  void set_torque_law(btMultiBody& multibody, TorqueLaw law, TorqueLawOrder order = TorqueLawOrder::two);
  void clear_torque_law(btCollisionObject& body);
  void clear_torque_law(btMultiBody& multibody);
  /// Sets the angular momentum of the rotors inside the body (RotationState::rotor_momentum_B, kg m^2/s)
  /// immediately.
  /// @throws std::invalid_argument also if the body's scheme takes no rotors; the message lists the schemes
  /// that do.
  void set_rotor_momentum(btCollisionObject& body, const Vector3& rotor_momentum_B, RotorChange change);
  void set_rotor_momentum(btMultiBody& multibody, const Vector3& rotor_momentum_B, RotorChange change);
  /// Sets the torque of motors inside the body on its rotors (N m, body axes), which acts until it is set to
  /// 0. The rotors gain its impulse, and L_W stays.
  /// @throws std::invalid_argument as set_rotor_momentum.
  void set_rotor_torque(btCollisionObject& body, const Vector3& rotor_torque_B);
  void set_rotor_torque(btMultiBody& multibody, const Vector3& rotor_torque_B);
  /// Returns the time passed to torque laws, s: the sum of dt since this object was created or set_time was
  /// called.
  double time() const;
  void set_time(double time_s);
  /// @}

  /// Returns true if the library rotates this body: it is in the world, dynamic, and has a scheme.
  bool manages(const btRigidBody& body) const;
  bool manages(const btMultiBody& multibody) const;
  /// Returns the body's present rotation: the library's double-precision state if the body is bit for bit as
  /// the last step left it, otherwise the body's own values. A velocity whose momentum or energy overflows a
  /// double is reported as 0; the body then diverges in its next step.
  /// @throws std::invalid_argument if the library does not rotate the body.
  BodyRotation rotation_of(const btRigidBody& body) const;
  BodyRotation rotation_of(const btMultiBody& multibody) const;
  /// Returns the number of bodies that the library rotates, including multibodies.
  std::size_t managed_bodies() const;
  /// Returns the bodies for which `manages` is true, in the order of the world's lists.
  std::vector<btRigidBody*> managed_rigid_bodies() const;
  std::vector<btMultiBody*> managed_multibodies() const;

  /// Sets the double-precision state of a body. The next step starts from exactly these values, whereas
  /// Bullet's setters would round them in a single-precision world. Updates L_W, and sets R_WB to the matrix
  /// of q_WB. Writes the rounded pose, interpolated pose and angular velocity to the body. A diverged body
  /// rotates again. Does not activate a sleeping body.
  /// @param q_WB normalized if its length is not 1
  /// @param omega_W rad/s
  /// @throws std::invalid_argument if the library does not rotate the body, a number is not finite, q_WB is
  /// zero, or |omega_W| exceeds kMaximumAngularSpeed (rotation_limits.h).
  /// @throws std::logic_error within a step, or while the plugin is detached.
  void set_rotation(btRigidBody& body, const Quaternion& q_WB, const Vector3& omega_W);

  /// @name Snapshots
  /// See snapshot.h for what snapshots contain and how to use them for rollback, lockstep and replay. All
  /// functions throw std::logic_error within a step, or while the plugin is detached. Restoring throws
  /// std::invalid_argument, and changes nothing, if the snapshot is damaged, contains numbers that are not
  /// finite, or is of another format version, precision, body or world; the message says what is wrong and
  /// what is valid. Restoring calls no contact callbacks. The next step updates motion states.
  /// @{
  /// Saves one body with its rotation. After restoring, the body repeats its steps in free flight bit for
  /// bit. Contact points belong to the world and are not included. Multibodies cannot be saved.
  /// @throws std::invalid_argument if the library does not rotate the body, or the body has a number that is
  /// not finite.
  Snapshot save(const btRigidBody& body) const;
  /// Restores one body, and sets the snapshot's scheme if the body has another one.
  /// @throws std::invalid_argument also if the body is not in the world.
  void restore(btRigidBody& body, const Snapshot& snapshot);
  /// Saves the whole world: all bodies, including those that the library does not rotate, with contacts and
  /// joints.
  /// @throws std::invalid_argument if a number is not finite, if the world has multibodies or soft bodies, or
  /// if its broadphase, pair cache or dispatcher is not a btDbvtBroadphase, btHashedOverlappingPairCache or
  /// btCollisionDispatcher.
  Snapshot save_world() const;
  /// Restores the world. Its bodies and joints must be in the order in which they were saved, unless `order`
  /// gives that order; the world's lists are then sorted accordingly. If memory runs out, the world is only
  /// partly restored; call again.
  void restore_world(const Snapshot& snapshot);
  void restore_world(const Snapshot& snapshot, const WorldOrder& order);
  /// @}

  /// Sets the incident handler, or removes it if `handler` is empty. Without a handler, incidents are only
  /// counted.
  void set_incident_handler(IncidentHandler handler);
  /// Returns the number of incidents so far, including repeated ones of the same body and kind.
  std::uint64_t incidents() const;

 private:
  friend class RotationPlugin;
  template <class Base>
  friend class RotationWorld;

  explicit RotationControl(btDynamicsWorld& world);

  // The stages of a step, see RotationWorld. `bullet` runs the stage of Bullet's own class.
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
