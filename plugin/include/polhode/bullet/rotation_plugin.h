#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <memory>

#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Rotates the bodies of a world that the application made: `RotationPlugin plugin(world);`.
///
/// Attaches to two places of the world. An island manager of the plugin's own stands in for the world's, to
/// see the start of each solve. The first of the world's actions is the plugin's, to replace the turn that
/// Bullet made right after its integration. The tick callbacks, the user pointers, the solver and the class
/// of the world stay the application's, and other actions see and change finished bodies. detach() leaves the
/// world exactly as it was found. A RotationPlugin and a RotationWorld give the same bits.
///
/// Lifetime: plugin and world may be destroyed in either order. After the world is gone the plugin is
/// detached for good. Before the application replaces the world's island manager it should detach() the
/// plugin: until the plugin's own island manager is back, Bullet rotates the bodies (attached() is false),
/// and the plugin is not told of the world's end.
class RotationPlugin final {
 public:
  /// Attaches to `world`.
  /// @throws std::invalid_argument for a world that cannot be hooked (btSimpleDynamicsWorld, the deformable
  /// world, one whose island manager is of a class of its own), or that the library rotates already.
  /// @throws std::runtime_error on a precision mismatch, see require_matching_bullet.
  explicit RotationPlugin(btDynamicsWorld& world);
  ~RotationPlugin();
  RotationPlugin(const RotationPlugin&) = delete;
  RotationPlugin& operator=(const RotationPlugin&) = delete;

  RotationControl& rotation() { return rotation_; }
  const RotationControl& rotation() const { return rotation_; }

  /// Gives every body back to Bullet and leaves the world; choices, default scheme and handler are kept. Does
  /// nothing if not attached.
  /// Do not call it within a step: the action after the plugin's would be skipped.
  void detach();
  /// Attaches again to the same world. Does nothing if attached.
  /// @throws std::invalid_argument as the constructor; std::logic_error if the world is gone. A plugin is told
  /// of its world's end while it is attached only: do not attach to a world that has gone since detach().
  void attach();
  /// Returns true while bodies are rotated by their schemes.
  bool attached() const;

 private:
  class Attachment;

  RotationControl rotation_;
  std::unique_ptr<Attachment> attachment_;  // null while detached
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
