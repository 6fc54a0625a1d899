#include "bullet/world/world_claim.h"

#include <mutex>
#include <stdexcept>
#include <unordered_set>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Worlds may be created and destroyed on several threads.
struct Register {
  std::mutex mutex;
  std::unordered_set<const btDynamicsWorld*> worlds;
};

Register& claimed() {
  static Register instance;
  return instance;
}

}  // namespace

void WorldClaim::claim(const btDynamicsWorld& world) {
  if (world_ == &world) return;
  const std::lock_guard<std::mutex> lock(claimed().mutex);
  if (!claimed().worlds.insert(&world).second) {
    throw std::invalid_argument(
        "a RotationWorld or another RotationPlugin already rotates the bodies of this world: use its "
        "rotation(), or detach() it first");
  }
  world_ = &world;
}

void WorldClaim::release() noexcept {
  if (world_ == nullptr) return;
  const std::lock_guard<std::mutex> lock(claimed().mutex);
  claimed().worlds.erase(world_);
  world_ = nullptr;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
