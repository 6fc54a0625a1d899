#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "polhode/bullet/precision.h"
#include "polhode/scheme_registry.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What the library knows of a body it rotates, in double precision.
struct BodyRotation {
  RotationState state;      ///< q_WB, R_WB, omega_W, L_W
  double energy_J = 0.0;    ///< rotational kinetic energy
  std::uint64_t steps = 0;  ///< taken with the present scheme
  bool diverged = false;    ///< the scheme blew up: `state` is the last finite one, the body spins no more
  std::string_view scheme;  ///< its name
};

enum class IncidentKind : std::uint8_t {
  scheme_diverged,  ///< the scheme left the finite or went past the bounds of rotation_limits.h
  non_finite_body,  ///< a NaN or infinity was found in the body's pose, velocity or forces and was taken out
};

struct Incident {
  IncidentKind kind;
  btRigidBody* body;
  std::uint64_t body_steps;  ///< steps the body had taken
};

/// Called within a step, when its bodies are done; once for each body and kind. It may choose another scheme
/// for the body, release it or take it out of the world. What it throws is dropped.
using IncidentHandler = std::function<void(const Incident&)>;

class WorldBodies;

/// Which body of a world is rotated by which scheme, and how they are doing. A RotationWorld and a
/// RotationPlugin each have one, `rotation()`.
///
/// Every dynamic body has the world's default scheme unless it was told otherwise. A body's choice lasts
/// until it is absent from the world during a step; it survives being removed and added again between two
/// steps. While a body is managed its BT_ENABLE_GYROSCOPIC_FORCE_* flags are cleared (else the term would
/// count twice); they are given back on release. Not thread-safe: call it from where you call stepSimulation.
class RotationControl {
 public:
  /// @throws std::invalid_argument for a world that cannot be hooked (btSimpleDynamicsWorld, the deformable
  /// world) or that another RotationControl has taken on.
  /// @throws std::runtime_error on a precision mismatch, see require_matching_bullet.
  explicit RotationControl(btDynamicsWorld& world);
  ~RotationControl();
  RotationControl(const RotationControl&) = delete;
  RotationControl& operator=(const RotationControl&) = delete;

  /// The scheme of every dynamic body that has none of its own; initially polhode::default_scheme().
  /// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or a null pointer.
  void set_default_scheme(std::string_view name);
  void set_default_scheme(SchemePointer scheme);
  /// Only bodies with a scheme of their own are rotated by the library from now on.
  void clear_default_scheme();

  /// The body is rotated by this scheme from the next step on, starting afresh from its present pose and
  /// velocity (a diverged body too).
  /// @throws std::invalid_argument for an unknown name, a null pointer, a static body, or an object that is
  /// no btRigidBody (a link of a btMultiBody).
  void set_scheme(btCollisionObject& body, std::string_view name);
  void set_scheme(btCollisionObject& body, SchemePointer scheme);
  /// The body has the world's default scheme again.
  void use_default_scheme(btCollisionObject& body);
  /// Bullet rotates the body again, with the gyroscopic flags that it had.
  void release(btCollisionObject& body);

  /// Whether the library rotates this body, as far as it has seen: a body added to the world of a
  /// RotationPlugin is first seen in the step after, or by RotationPlugin::take_over_changes.
  bool manages(const btRigidBody& body) const;
  /// The body's rotation as it stands: the library's double state where the body is bit for bit as the last
  /// step left it, else what the body says now.
  /// @throws std::invalid_argument if the body is not managed.
  BodyRotation rotation_of(const btRigidBody& body) const;
  std::size_t managed_bodies() const;

  /// Replaces the handler; an empty one is allowed. Without a handler incidents are only counted.
  void set_incident_handler(IncidentHandler handler);
  /// Incidents since the start, also those after a body's first.
  std::uint64_t incidents() const;

  /// @name For the two ways in
  /// @{
  /// Before the solver: finds new bodies, takes over what the application changed since the last step.
  void begin_step() noexcept;
  /// After Bullet's own integration by dt seconds: rotates every managed body that Bullet moved.
  void finish_step(btScalar dt) noexcept;

  /// begin_step, for a world that can pass over bodies: predicts where `own` bodies of the library come in dt
  /// seconds. Until the step ends Bullet need not move and turn them; it has to be kept from them by
  /// hide_own_bodies where it would. All others are left to Bullet, for finish_other_bodies.
  void begin_step_and_predict(btScalar dt) noexcept;
  /// Takes the own bodies out of the world's list of bodies until unhide_own_bodies.
  void hide_own_bodies();
  void unhide_own_bodies() noexcept;
  /// btCollisionWorld::updateAabbs, with a look ahead in memory.
  void update_boxes();
  /// After the solver, in place of Bullet's integration.
  void move_and_rotate_own_bodies(btScalar dt) noexcept;
  /// finish_step, for the others.
  void finish_other_bodies(btScalar dt) noexcept;
  /// Hands the pose of each own body that is awake to its motion state.
  void show_own_bodies();

  /// Hands the R_WB of bodies whose scheme does not keep a rotation to their motion states as it is.
  void show_swollen_bodies() noexcept;
  /// The same, without those that show_own_bodies has shown.
  void show_other_swollen_bodies() noexcept;
  /// A body entered or is leaving the world.
  void body_added(btRigidBody& body);
  void body_removed(btRigidBody& body);
  /// Takes on every body of the world; done by the constructor.
  /// @throws std::invalid_argument if another RotationControl has taken on the world.
  void take_on_world();
  /// Gives every body of the world back to Bullet; choices, default scheme and handler are kept.
  void leave_world();
  /// Forgets the world and every body without touching them. set_scheme and its like throw std::logic_error
  /// after.
  void world_is_gone() noexcept;
  /// @}

 private:
  std::unique_ptr<WorldBodies> bodies_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
