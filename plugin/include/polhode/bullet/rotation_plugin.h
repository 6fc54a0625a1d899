#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <memory>

#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Rotates the bodies of an existing world: `RotationPlugin plugin(world);`.
///
/// Hooks into the world in two places. An island manager of the plugin's replaces the world's; Bullet calls
/// it at the start of each solve. An action of the plugin's comes first in the world's list; it replaces
/// Bullet's rotation right after Bullet's integration. The world's tick callbacks, user pointers, solver and
/// class stay untouched, and the application's actions see and change bodies whose step is complete. detach()
/// restores the world exactly. RotationPlugin and RotationWorld give bit-identical results.
///
/// Plugin and world may be destroyed in either order. When the world is destroyed, the plugin is detached for
/// good. Call detach() before replacing the world's island manager. Otherwise Bullet rotates the bodies
/// (attached() is false) until the plugin's island manager is put back, and the plugin cannot notice the end
/// of the world.
class RotationPlugin final {
 public:
  /// Attaches to `world`.
  /// @throws std::invalid_argument if the world cannot be hooked (btSimpleDynamicsWorld, a deformable world,
  /// or a custom island manager class), or if the library already rotates its bodies.
  /// @throws std::runtime_error on a precision mismatch, see require_matching_bullet.
  explicit RotationPlugin(btDynamicsWorld& world);
  ~RotationPlugin();
  RotationPlugin(const RotationPlugin&) = delete;
  RotationPlugin& operator=(const RotationPlugin&) = delete;

  RotationControl& rotation() { return rotation_; }
  const RotationControl& rotation() const { return rotation_; }

  /// Returns every body to Bullet and unhooks from the world. Keeps the chosen schemes, the default scheme
  /// and the incident handler. Does nothing if not attached. Do not call within a step: Bullet would skip the
  /// action after the plugin's.
  void detach();
  /// Attaches to the same world again. Does nothing if attached. The world must still exist: a detached
  /// plugin does not notice that its world is destroyed.
  /// @throws std::invalid_argument as the constructor.
  /// @throws std::logic_error if the world was destroyed while the plugin was attached.
  void attach();
  /// Returns true while the schemes rotate the bodies.
  bool attached() const;

 private:
  class Attachment;

  RotationControl rotation_;
  std::unique_ptr<Attachment> attachment_;  // null while detached
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
