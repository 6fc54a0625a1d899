// A plugin leaves its world exactly as it found it, for each kind of Bullet world, even if the application
// changed the world meanwhile.
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/Dynamics/btSimulationIslandManagerMt.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <typeinfo>
#include <vector>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/motion.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);

/// Gives access to the protected members of a world.
class Members : public btDiscreteDynamicsWorld {
 public:
  static btSimulationIslandManager*& island_manager(btDiscreteDynamicsWorld& world) {
    return world.*(&Members::m_islandManager);
  }
  static bool owns_island_manager(btDiscreteDynamicsWorld& world) {
    return world.*(&Members::m_ownsIslandManager);
  }
  static std::vector<btActionInterface*> actions(btDiscreteDynamicsWorld& world) {
    const btAlignedObjectArray<btActionInterface*>& list = world.*(&Members::m_actions);
    std::vector<btActionInterface*> copy;
    for (int i = 0; i < list.size(); ++i) copy.push_back(list[i]);
    return copy;
  }
  static btInternalTickCallback tick(btDiscreteDynamicsWorld& world) {
    return world.*(&Members::m_internalTickCallback);
  }
  static btInternalTickCallback pre_tick(btDiscreteDynamicsWorld& world) {
    return world.*(&Members::m_internalPreTickCallback);
  }
};

class CountingAction final : public btActionInterface {
 public:
  void updateAction(btCollisionWorld* /*world*/, btScalar /*dt*/) override { ++count; }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}
  int count = 0;
};

void tick(btDynamicsWorld* /*world*/, btScalar /*dt*/) {}
void pre_tick(btDynamicsWorld* /*world*/, btScalar /*dt*/) {}

/// Everything that a plugin might change.
struct Inventory {
  explicit Inventory(btDiscreteDynamicsWorld& world)
      : actions(Members::actions(world)),
        island_manager(Members::island_manager(world)),
        kind(&typeid(*island_manager)),
        owns(Members::owns_island_manager(world)),
        split(world.getSimulationIslandManager()->getSplitIslands()),
        solver(world.getConstraintSolver()),
        ticks{Members::tick(world), Members::pre_tick(world)},
        user_info(world.getWorldUserInfo()),
        objects(world.getNumCollisionObjects()),
        joints(world.getNumConstraints()) {}

  bool operator==(const Inventory& other) const {
    return actions == other.actions && island_manager == other.island_manager && *kind == *other.kind &&
           owns == other.owns && split == other.split && solver == other.solver &&
           ticks[0] == other.ticks[0] && ticks[1] == other.ticks[1] && user_info == other.user_info &&
           objects == other.objects && joints == other.joints;
  }

  std::vector<btActionInterface*> actions;
  btSimulationIslandManager* island_manager;
  const std::type_info* kind;
  bool owns, split;
  btConstraintSolver* solver;
  btInternalTickCallback ticks[2];
  void* user_info;
  int objects, joints;
};

template <class World>
class WorldLeftAsFound : public ::testing::Test {
 protected:
  // A world in use, with actions, tick callbacks and bodies.
  WorldLeftAsFound() : scene_(std::make_unique<Scene<World>>()) {
    world().addAction(&first_);
    world().addAction(&second_);
    world().addAction(&third_);
    world().setInternalTickCallback(tick, this, false);
    world().setInternalTickCallback(pre_tick, this, true);
    body_ = &scene_->add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    scene_->step(kDt);
  }
  ~WorldLeftAsFound() override {
    if (scene_ == nullptr) return;
    for (btActionInterface* action : {&first_, &second_, &third_}) world().removeAction(action);
  }

  World& world() { return scene_->world(); }

  CountingAction first_, second_, third_;
  std::unique_ptr<Scene<World>> scene_;
  btRigidBody* body_;
};

using Worlds = ::testing::Types<btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld,
                                btMultiBodyDynamicsWorld>;
TYPED_TEST_SUITE(WorldLeftAsFound, Worlds);

TYPED_TEST(WorldLeftAsFound, AfterAPluginThatStepped) {
  for (const bool split : {true, false}) {
    this->world().getSimulationIslandManager()->setSplitIslands(split);
    const Inventory before(this->world());
    {
      RotationPlugin plugin(this->world());
      this->scene_->step(kDt, 10);
      EXPECT_EQ(plugin.rotation().rotation_of(*this->body_).steps, 10u);
    }
    EXPECT_TRUE(Inventory(this->world()) == before);
    this->scene_->step(kDt, 10);
    EXPECT_TRUE(Inventory(this->world()) == before);
  }
}

TYPED_TEST(WorldLeftAsFound, AfterAPluginThatNeverStepped) {
  const Inventory before(this->world());
  { RotationPlugin plugin(this->world()); }
  EXPECT_TRUE(Inventory(this->world()) == before);
}

TYPED_TEST(WorldLeftAsFound, AfterManyRoundsOfDetachingAndAttaching) {
  const Inventory before(this->world());
  RotationPlugin plugin(this->world());
  for (int i = 0; i < 5; ++i) {
    this->scene_->step(kDt, 2);
    plugin.detach();
    EXPECT_FALSE(plugin.attached());
    EXPECT_TRUE(Inventory(this->world()) == before) << i;
    this->scene_->step(kDt, 2);
    plugin.attach();
    EXPECT_TRUE(plugin.attached());
    EXPECT_FALSE(Inventory(this->world()) == before) << i;
  }
  EXPECT_TRUE(plugin.rotation().manages(*this->body_));
}

// Changes that the application makes while a plugin is attached are kept.
TYPED_TEST(WorldLeftAsFound, ExceptForTheApplicationsOwnChanges) {
  RotationPlugin plugin(this->world());
  this->world().getSimulationIslandManager()->setSplitIslands(false);
  this->world().removeAction(&this->second_);
  CountingAction fourth;
  this->world().addAction(&fourth);
  this->scene_->step(kDt, 3);
  plugin.detach();
  EXPECT_FALSE(this->world().getSimulationIslandManager()->getSplitIslands());
  const std::vector<btActionInterface*> expected = {&this->first_, &this->third_, &fourth};
  EXPECT_EQ(Members::actions(this->world()), expected);
  EXPECT_EQ(fourth.count, 3);
  this->world().removeAction(&fourth);
}

// The plugin's action comes first, whatever was added before or after.
TYPED_TEST(WorldLeftAsFound, HasThePluginBeforeAllActionsWhileAttached) {
  RotationPlugin plugin(this->world());
  CountingAction fourth;
  this->world().addAction(&fourth);
  this->scene_->step(kDt);
  const std::vector<btActionInterface*> actions = Members::actions(this->world());
  ASSERT_EQ(actions.size(), 5u);
  const std::vector<btActionInterface*> others(actions.begin() + 1, actions.end());
  const std::vector<btActionInterface*> expected = {&this->first_, &this->second_, &this->third_, &fourth};
  EXPECT_EQ(others, expected);
  this->world().removeAction(&fourth);
}

// The plugin's island manager has the same type as the world's: in a multithreaded world a multithreaded one,
// with the same settings.
TYPED_TEST(WorldLeftAsFound, HasAnIslandManagerOfTheSameTypeWhileAttached) {
  auto* const multi_threaded =
      dynamic_cast<btSimulationIslandManagerMt*>(Members::island_manager(this->world()));
  if (multi_threaded != nullptr) {
    multi_threaded->setMinimumSolverBatchSize(77);
    multi_threaded->setIslandDispatchFunction(btSimulationIslandManagerMt::serialIslandDispatch);
  }
  RotationPlugin plugin(this->world());
  btSimulationIslandManager* const ours = this->world().getSimulationIslandManager();
  ASSERT_NE(ours, nullptr);
  auto* const ours_multi_threaded = dynamic_cast<btSimulationIslandManagerMt*>(ours);
  EXPECT_EQ(ours_multi_threaded != nullptr, multi_threaded != nullptr);
  if (ours_multi_threaded == nullptr) return;
  EXPECT_EQ(ours_multi_threaded->getMinimumSolverBatchSize(), 77);
  EXPECT_EQ(ours_multi_threaded->getIslandDispatchFunction(),
            &btSimulationIslandManagerMt::serialIslandDispatch);
  ours_multi_threaded->setMinimumSolverBatchSize(55);
  plugin.detach();
  EXPECT_EQ(multi_threaded->getMinimumSolverBatchSize(), 55);
}

// After its world is deleted, the plugin does nothing.
TYPED_TEST(WorldLeftAsFound, MayBeDeletedBeforeItsPlugin) {
  RotationPlugin plugin(this->world());
  this->scene_->step(kDt, 3);
  this->scene_.reset();
  EXPECT_FALSE(plugin.attached());
  EXPECT_EQ(plugin.rotation().managed_bodies(), 0u);
  btSphereShape shape(1);
  btRigidBody body(1, nullptr, &shape, btVector3(1, 1, 1));
  EXPECT_FALSE(plugin.rotation().manages(body));
  EXPECT_THROW(plugin.rotation().set_scheme(body, "matrix"), std::logic_error);
  EXPECT_THROW(plugin.rotation().use_default_scheme(body), std::logic_error);
  EXPECT_THROW(plugin.rotation().release(body), std::logic_error);
  EXPECT_THROW(plugin.rotation().rotation_of(body), std::logic_error);
  EXPECT_THROW(plugin.attach(), std::logic_error);
  EXPECT_FALSE(plugin.attached());
  plugin.detach();
}

// The world may also be deleted while the plugin is detached. The plugin's own island manager then cannot
// report the deletion, and the plugin may only be destroyed afterwards.
TYPED_TEST(WorldLeftAsFound, MayBeDeletedWhileItsPluginIsDetached) {
  auto plugin = std::make_unique<RotationPlugin>(this->world());
  plugin->detach();
  this->scene_.reset();
  EXPECT_FALSE(plugin->attached());
  plugin.reset();
}

// A new world at the address of a deleted one is a different world.
TYPED_TEST(WorldLeftAsFound, MayBeReplacedByAnotherAtItsAddress) {
  for (int i = 0; i < 3; ++i) {
    auto scene = std::make_unique<Scene<TypeParam>>();
    RotationPlugin plugin(scene->world());
    btRigidBody& body = scene->add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    scene->step(kDt, 2);
    EXPECT_EQ(plugin.rotation().rotation_of(body).steps, 2u);
    scene.reset();
    EXPECT_FALSE(plugin.attached());
  }
}

TYPED_TEST(WorldLeftAsFound, RefusesASecondPluginAndTheFirstGoesOn) {
  RotationPlugin first(this->world());
  this->scene_->step(kDt, 2);
  const Inventory before(this->world());
  EXPECT_THROW(RotationPlugin second(this->world()), std::invalid_argument);
  EXPECT_TRUE(Inventory(this->world()) == before);
  this->scene_->step(kDt, 2);
  EXPECT_EQ(first.rotation().rotation_of(*this->body_).steps, 4u);
  first.detach();
  RotationPlugin third(this->world());
  EXPECT_THROW(first.attach(), std::invalid_argument);
  this->scene_->step(kDt, 2);
  EXPECT_EQ(third.rotation().rotation_of(*this->body_).steps, 2u);
}

// Detaches in the tick callbacks at the start and end of a step.
TYPED_TEST(WorldLeftAsFound, AfterAPluginThatIsDetachedWithinAStep) {
  const Inventory before(this->world());
  RotationPlugin plugin(this->world());
  this->scene_->step(kDt);
  for (const bool pre : {true, false}) {
    plugin.attach();
    this->world().setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
          static_cast<RotationPlugin*>(world->getWorldUserInfo())->detach();
        },
        &plugin, pre);
    this->scene_->step(kDt);
    EXPECT_FALSE(plugin.attached());
    this->world().setInternalTickCallback(pre ? pre_tick : tick, this, pre);
    EXPECT_TRUE(Inventory(this->world()) == before) << pre;
    this->scene_->step(kDt);
  }
  EXPECT_EQ(this->body_->getFlags(), BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
}

/// An application's own island manager, which replaces the world's.
class TheirManager : public btSimulationIslandManager {
 public:
  void updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) override {
    ++count;
    btSimulationIslandManager::updateActivationState(world, dispatcher);
  }
  int count = 0;
};

class TheirManagerMt : public btSimulationIslandManagerMt {
 public:
  void updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) override {
    ++count;
    btSimulationIslandManagerMt::updateActivationState(world, dispatcher);
  }
  int count = 0;
};

template <class World>
using ManagerFor =
    std::conditional_t<std::is_base_of_v<btDiscreteDynamicsWorldMt, World>, TheirManagerMt, TheirManager>;

// The plugin refuses a custom island manager, whose behaviour it could not reproduce.
TYPED_TEST(WorldLeftAsFound, IsRefusedWithAnIslandManagerOfTheApplicationsOwn) {
  ManagerFor<TypeParam> theirs;
  btSimulationIslandManager* const own = std::exchange(Members::island_manager(this->world()), &theirs);
  const Inventory before(this->world());
  try {
    RotationPlugin plugin(this->world());
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("island manager"));
  }
  EXPECT_TRUE(Inventory(this->world()) == before);
  this->scene_->step(kDt);
  EXPECT_EQ(theirs.count, 1);
  Members::island_manager(this->world()) = own;
  EXPECT_NO_THROW(RotationPlugin plugin(this->world()));
}

// The application replaces the island manager while the plugin is attached, and restores it before the plugin
// is destroyed.
TYPED_TEST(WorldLeftAsFound, EvenIfItsIslandManagerWasReplacedTemporarily) {
  const Inventory before(this->world());
  {
    RotationPlugin plugin(this->world());
    this->scene_->step(kDt);
    ManagerFor<TypeParam> theirs;
    btSimulationIslandManager* const plugins = std::exchange(Members::island_manager(this->world()), &theirs);
    this->scene_->step(kDt, 3);
    EXPECT_EQ(theirs.count, 3);
    EXPECT_TRUE(basis_of(*this->body_).allFinite());
    Members::island_manager(this->world()) = plugins;
    this->scene_->step(kDt, 3);
    EXPECT_TRUE(plugin.attached());
  }
  EXPECT_TRUE(Inventory(this->world()) == before);
}

// The application replaces the island manager and does not restore it before the plugin is destroyed. The
// application's manager stays, and the plugin's continues to work as a plain one. If it is put back later,
// the world frees it together with the original one.
TYPED_TEST(WorldLeftAsFound, ExceptForAnIslandManagerThatTheApplicationReplaced) {
  ManagerFor<TypeParam> theirs;
  btSimulationIslandManager* plugins = nullptr;
  {
    RotationPlugin plugin(this->world());
    this->scene_->step(kDt);
    plugins = std::exchange(Members::island_manager(this->world()), &theirs);
    this->scene_->step(kDt);
  }
  ASSERT_NE(plugins, nullptr);
  EXPECT_EQ(Members::island_manager(this->world()), &theirs);
  this->scene_->step(kDt, 2);
  EXPECT_EQ(theirs.count, 3);
  const std::vector<btActionInterface*> expected = {&this->first_, &this->second_, &this->third_};
  EXPECT_EQ(Members::actions(this->world()), expected);
  Members::island_manager(this->world()) = plugins;
  this->scene_->step(kDt, 2);
  EXPECT_EQ(theirs.count, 3);
  EXPECT_TRUE(basis_of(*this->body_).allFinite());
}

}  // namespace
}  // namespace polhode::testing
