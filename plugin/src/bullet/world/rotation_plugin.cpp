#include "polhode/bullet/rotation_plugin.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/Dynamics/btSimulationIslandManagerMt.h>
#include <LinearMath/btAlignedAllocator.h>

#include <new>
#include <stdexcept>
#include <typeinfo>
#include <utility>

#include "bullet/internals/private_members.h"
#include "bullet/world/world_stepper.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

/// Receives the calls of a ListeningManager.
class SolveListener {
 public:
  /// Called once in each substep, after collision detection and right before the solver.
  virtual void before_solve() = 0;
  /// Called when the world is being destroyed.
  virtual void world_dies() = 0;

 protected:
  ~SolveListener() = default;
};

void copy_settings(btSimulationIslandManager& from, btSimulationIslandManager& to) {
  to.setSplitIslands(from.getSplitIslands());
}

void copy_settings(btSimulationIslandManagerMt& from, btSimulationIslandManagerMt& to) {
  to.setSplitIslands(from.getSplitIslands());
  to.setMinimumSolverBatchSize(from.getMinimumSolverBatchSize());
  to.setIslandDispatchFunction(from.getIslandDispatchFunction());
}

// Destroys an island manager as the world destroys its own.
void destroy(btSimulationIslandManager& manager) {
  manager.~btSimulationIslandManager();
  btAlignedFree(&manager);
}

// The part of ListeningManager that does not depend on the class that it replaces.
class Listening {
 public:
  virtual ~Listening() = default;
  virtual void forget_listener() = 0;
  /// Returns the world's own manager with the present settings. Afterwards the caller owns it.
  virtual btSimulationIslandManager& give_back() = 0;
};

template <class Manager>
class ListeningManager final : public Manager, public Listening {
 public:
  ListeningManager(Manager& worlds_own, SolveListener& listener)
      : worlds_own_(&worlds_own), listener_(&listener) {
    copy_settings(worlds_own, *this);
  }
  // Called by Bullet when it destroys the world.
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

// Also true for one of ours, left in the world without a listener.
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
  if (memory == nullptr) throw std::bad_alloc();
  return new (memory) Ours(static_cast<Manager&>(worlds_own), listener);
}

btSimulationIslandManager* make_listening(btSimulationIslandManager& worlds_own, SolveListener& listener) {
  if (is_plain<btSimulationIslandManager>(worlds_own))
    return listening<btSimulationIslandManager>(worlds_own, listener);
  if (is_plain<btSimulationIslandManagerMt>(worlds_own)) {
    return listening<btSimulationIslandManagerMt>(worlds_own, listener);
  }
  throw std::invalid_argument(
      "the island manager of this world is of a custom class, which RotationPlugin cannot replace: valid are "
      "btSimulationIslandManager and btSimulationIslandManagerMt; or use a RotationWorld");
}

}  // namespace

/// Occupies the plugin's two places in the world: the first action, and the island manager. Bullet calls the
/// manager's updateActivationState at the start of a solve, and destroys the manager with the world. The
/// manager has the settings of the one that it replaces, so the application can use it as before.
class RotationPlugin::Attachment final : public btActionInterface, public SolveListener {
 public:
  explicit Attachment(RotationPlugin& plugin)
      : plugin_(plugin),
        world_(plugin.rotation_.stepper_->world()),
        manager_(make_listening(*island_manager(world_), *this)) {
    island_manager(world_) = manager_;
    world_.addAction(this);
    move_to_front();
  }

  // Moves to the back first: Bullet removes an action by putting the last one in its place.
  ~Attachment() override {
    move_to_back();
    world_.removeAction(this);
    if (manager_ != nullptr) put_back_manager();
  }

  /// Returns false if the application has replaced the island manager.
  bool is_in_place() const { return island_manager(world_) == manager_; }

  void before_solve() override {
    if (actions(world_)[0] != this) move_to_front();
    plugin_.rotation_.before_solve();
  }
  void updateAction(btCollisionWorld* /*world*/, btScalar dt) override {
    plugin_.rotation_.after_integration(dt);
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

  void world_dies() override {
    manager_ = nullptr;  // destroyed by the world
    plugin_.rotation_.stepper_->world_is_gone();
    plugin_.attachment_.reset();  // deletes this object
  }

 private:
  // If the application has replaced our manager, its manager stays. Ours then works as a plain one.
  void put_back_manager() {
    auto& ours = dynamic_cast<Listening&>(*manager_);
    ours.forget_listener();
    if (!is_in_place()) return;
    island_manager(world_) = &ours.give_back();
    destroy(*manager_);
  }
  int position() const {
    int position = 0;
    while (position < actions(world_).size() && actions(world_)[position] != this) ++position;
    return position;
  }
  void move_to_front() {
    for (int i = position(); i > 0 && i < actions(world_).size(); --i)
      std::swap(actions(world_)[i], actions(world_)[i - 1]);
  }
  void move_to_back() {
    for (int i = position(); i + 1 < actions(world_).size(); ++i)
      std::swap(actions(world_)[i], actions(world_)[i + 1]);
  }

  RotationPlugin& plugin_;
  btDiscreteDynamicsWorld& world_;
  btSimulationIslandManager* manager_;
};

RotationPlugin::RotationPlugin(btDynamicsWorld& world) : rotation_(world) {
  attachment_ = std::make_unique<Attachment>(*this);
}

RotationPlugin::~RotationPlugin() = default;

void RotationPlugin::attach() {
  if (attached()) return;
  detach();
  try {
    rotation_.stepper_->attach();
    attachment_ = std::make_unique<Attachment>(*this);
  } catch (...) {
    detach();
    throw;
  }
}

void RotationPlugin::detach() {
  attachment_.reset();
  rotation_.stepper_->detach();
}

bool RotationPlugin::attached() const {
  return attachment_ != nullptr && attachment_->is_in_place();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
