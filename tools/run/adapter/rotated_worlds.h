#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "polhode/bullet/rotation_plugin.h"
#include "run/adapter/adapter.h"
#include "run/adapter/counters.h"

class btMultiBodyDynamicsWorld;

namespace polhode::run {

/// Attaches a RotationPlugin to each world that is stepped, and counts steps, bodies and incidents.
///
/// Notices that a world was destroyed when another one is stepped at the same address. Only few plugins of
/// destroyed worlds remain, since allocators reuse addresses.
class RotatedWorlds {
 public:
  RotatedWorlds(const char* scheme, Report report) : scheme_(scheme), report_(report) {}

  /// Attaches a plugin to a world that is new. Returns true if the world's bodies are rotated.
  bool before_step(btDynamicsWorld& world) noexcept;
  Counters& counters() { return counters_; }

 private:
  struct RotatedWorld {
    std::unique_ptr<RotationPlugin> plugin;  ///< null: the world is left to Bullet
    btMultiBodyDynamicsWorld* with_multibodies = nullptr;
    /// Two successive worlds at one address differ in one of these, or are left to Bullet for the same
    /// reason.
    const char* type_name = nullptr;
    const void* dispatcher = nullptr;
  };

  void see(RotatedWorld& seen, btDynamicsWorld& world);
  void attach(RotatedWorld& seen, btDynamicsWorld& world);
  std::unique_ptr<RotationPlugin> make_plugin(btDynamicsWorld& world);
  void leave_to_bullet(const btDynamicsWorld& world, const std::string& reason);
  void count_bodies(const RotatedWorld& seen);

  const std::string scheme_;
  const Report report_;
  Counters counters_;
  std::mutex mutex_;  ///< guards the members below
  std::unordered_map<const btDynamicsWorld*, RotatedWorld> worlds_;
  std::unordered_set<std::string> reported_;
};

}  // namespace polhode::run
