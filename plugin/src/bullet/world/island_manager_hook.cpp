#include "bullet/world/island_manager_hook.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/Dynamics/btSimulationIslandManagerMt.h>
#include <LinearMath/btAlignedAllocator.h>

#include <new>
#include <stdexcept>
#include <typeinfo>

#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

void copy_settings(btSimulationIslandManager& from, btSimulationIslandManager& to) {
  to.setSplitIslands(from.getSplitIslands());
}

void copy_settings(btSimulationIslandManagerMt& from, btSimulationIslandManagerMt& to) {
  to.setSplitIslands(from.getSplitIslands());
  to.setMinimumSolverBatchSize(from.getMinimumSolverBatchSize());
  to.setIslandDispatchFunction(from.getIslandDispatchFunction());
}

// As the world makes and destroys its own.
void destroy(btSimulationIslandManager& manager) {
  manager.~btSimulationIslandManager();
  btAlignedFree(&manager);
}

/// What IslandManagerHook asks of ours, whichever class it stands in for.
class Listening {
 public:
  virtual ~Listening() = default;
  virtual void forget_listener() = 0;
  /// Returns the world's own manager with the present settings; it is no longer ours to destroy.
  virtual btSimulationIslandManager& give_back() = 0;
};

template <class Manager>
class ListeningManager final : public Manager, public Listening {
 public:
  ListeningManager(Manager& worlds_own, SolveListener& listener)
      : worlds_own_(&worlds_own), listener_(&listener) {
    copy_settings(worlds_own, *this);
  }
  // Bullet destroys it with the world.
  ~ListeningManager() override {
    if (listener_ != nullptr) listener_->world_dies();
    if (worlds_own_ != nullptr) destroy(*worlds_own_);
  }
  ListeningManager(const ListeningManager&) = delete;
  ListeningManager& operator=(const ListeningManager&) = delete;

  void updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) override {
    if (listener_ != nullptr) listener_->before_solve();
    Manager::updateActivationState(world, dispatcher);
  }

  void forget_listener() override { listener_ = nullptr; }
  btSimulationIslandManager& give_back() override {
    copy_settings(*this, *worlds_own_);
    Manager& own = *worlds_own_;
    worlds_own_ = nullptr;
    return own;
  }

 private:
  Manager* worlds_own_;
  SolveListener* listener_;
};

// Ours, which nobody listens to any more, is as good as the plain one.
template <class Manager>
bool is_plain(const btSimulationIslandManager& manager) {
  return typeid(manager) == typeid(Manager) || typeid(manager) == typeid(ListeningManager<Manager>);
}

template <class Manager>
btSimulationIslandManager* listening(btSimulationIslandManager& worlds_own, SolveListener& listener) {
  using Ours = ListeningManager<Manager>;
  constexpr int kAlignment = 16;
  static_assert(alignof(Ours) <= kAlignment, "Bullet frees it with btAlignedFree");
  void* memory = btAlignedAlloc(sizeof(Ours), kAlignment);
  return new (memory) Ours(static_cast<Manager&>(worlds_own), listener);
}

btSimulationIslandManager* make(btSimulationIslandManager& worlds_own, SolveListener& listener) {
  if (is_plain<btSimulationIslandManager>(worlds_own))
    return listening<btSimulationIslandManager>(worlds_own, listener);
  if (is_plain<btSimulationIslandManagerMt>(worlds_own)) {
    return listening<btSimulationIslandManagerMt>(worlds_own, listener);
  }
  throw std::invalid_argument(
      "the island manager of this world is of a class of its own, and RotationPlugin would have to take its "
      "place: put "
      "Bullet's own in (btSimulationIslandManager or btSimulationIslandManagerMt), or make the world as a "
      "RotationWorld");
}

}  // namespace

IslandManagerHook::IslandManagerHook(btDiscreteDynamicsWorld& world, SolveListener& listener)
    : world_(world), own_(make(*island_manager(world), listener)) {
  island_manager(world) = own_;
}

IslandManagerHook::~IslandManagerHook() {
  if (own_ == nullptr) return;
  auto& own = dynamic_cast<Listening&>(*own_);
  own.forget_listener();
  if (!is_in_place()) return;
  island_manager(world_) = &own.give_back();
  destroy(*own_);
}

bool IslandManagerHook::is_in_place() const {
  return island_manager(world_) == own_;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
