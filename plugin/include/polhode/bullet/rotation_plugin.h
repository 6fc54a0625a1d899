#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Rotates the bodies of a world that somebody else made: `RotationPlugin plugin(world);`. It is one
/// btActionInterface in the world's list and touches nothing else: no tick callback, no user pointer, no
/// solver, no subclass. It runs right after Bullet's own integration and replaces the turn Bullet made.
///
/// An action cannot see the start of a step. So
/// - a body added later is first seen at the end of its first step, which was Bullet's own;
/// - a velocity that the application sets between two steps reaches the schemes as a kick in the step after;
/// - a gyroscopic flag that the application sets between two steps acts in the next one, and is cleared then;
/// - a NaN that the application puts into a body has met the solver before it is found; every managed body
///   that it reached is then set back to its last finite state.
/// Where that matters, call take_over_changes() before stepSimulation, after any such change; RotationWorld
/// does so by itself. The two then give the same bits, but for what other actions of the world do: those
/// before this one in the list see the body as Bullet turned it, in a RotationWorld as the scheme did.
///
/// Lifetime: the destructor detaches, and must run while the world and the bodies in it are alive; so declare
/// the plugin after the world. Bullet tells nobody when a world dies: in the other order call world_is_gone()
/// first.
class RotationPlugin final : public btActionInterface {
 public:
  /// Attaches to `world`.
  /// @throws std::invalid_argument for a world that cannot be hooked (btSimpleDynamicsWorld, the deformable
  /// world), or that the library rotates already.
  explicit RotationPlugin(btDynamicsWorld& world);
  ~RotationPlugin() override;
  RotationPlugin(const RotationPlugin&) = delete;
  RotationPlugin& operator=(const RotationPlugin&) = delete;

  RotationControl& rotation() { return rotation_; }
  const RotationControl& rotation() const { return rotation_; }

  /// Gives every body back to Bullet and leaves the world; choices, default scheme and handler are kept. Does
  /// nothing if not attached.
  void detach();
  /// Attaches again to the same world. Does nothing if attached.
  /// @throws std::invalid_argument if another plugin has taken the world meanwhile.
  void attach();
  bool attached() const { return attached_; }

  /// Optional, before stepSimulation: finds new bodies and takes over what the application changed since the
  /// last step, as a RotationWorld does.
  void take_over_changes() noexcept { rotation_.begin_step(); }

  /// The world was destroyed: forget it without touching it. The plugin can only be destroyed after this.
  void world_is_gone() noexcept;

  /// @name Called by Bullet
  /// @{
  void updateAction(btCollisionWorld* world, btScalar dt) override;
  void debugDraw(btIDebugDraw* /*drawer*/) override {}
  /// @}

 private:
  btDynamicsWorld* world_;
  RotationControl rotation_;
  bool attached_ = false;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
