// Lets each allocation of the library fail in turn. Configuration functions throw std::bad_alloc and change
// nothing; steps continue.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "support/both_ways.h"
#include "support/counted_heap.h"
#include "support/same_bits.h"
#include "support/same_body_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60.0);

// play(granted) must run with memory for `granted` allocations and return true if more were needed. Returns
// the number of allocations that were made to fail.
template <class Play>
std::size_t refuse_each_allocation(const Play& play) {
  std::size_t granted = 0;
  while (!::testing::Test::HasFatalFailure() && play(granted)) ++granted;
  return granted;
}

template <class Call>
bool throws_bad_alloc(const Call& call) {
  try {
    call();
  } catch (const std::bad_alloc&) {
    return true;
  }
  return false;
}

bool is_finite(const btRigidBody& body) {
  const btTransform& pose = body.getWorldTransform();
  const btVector3 sum = pose.getBasis()[0] + pose.getBasis()[1] + pose.getBasis()[2] + pose.getOrigin() +
                        body.getLinearVelocity() + body.getAngularVelocity();
  return std::isfinite(sum.x()) && std::isfinite(sum.y()) && std::isfinite(sum.z());
}

template <class Way>
void add_free_bodies(Scene<Way>& scene, int count) {
  for (int i = 0; i < count; ++i) {
    scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, btScalar(0.1) * btScalar(i)));
  }
}

struct Managed {
  BodyRotation rotation;
  bool is_managed;
};

Managed managed(const RotationControl& rotation, const btRigidBody& body) {
  if (!rotation.manages(body)) return {{}, false};
  return {rotation.rotation_of(body), true};
}

bool same(const Managed& a, const Managed& b) {
  return a.is_managed == b.is_managed && a.rotation.steps == b.rotation.steps &&
         a.rotation.scheme == b.rotation.scheme && same_bits(a.rotation.state, b.rotation.state);
}

// A new scheme would take effect when the body is added again.
template <class Way>
void expect_choice(Way& scene, btRigidBody& body, const Managed& before) {
  scene.world().removeRigidBody(&body);
  scene.rotation().managed_bodies();
  scene.world().addRigidBody(&body);
  EXPECT_EQ(managed(scene.rotation(), body).rotation.scheme, before.rotation.scheme);
}

// Lets each allocation of call(scene) fail in turn. Expects all bodies unchanged after a failure, and success
// when called again.
template <class Way, class Call>
std::size_t expect_all_or_nothing(const Call& call) {
  return refuse_each_allocation([&](std::size_t granted) {
    Way scene;
    add_free_bodies(scene, 20);
    scene.step(kDt, 2);
    add_free_bodies(scene, 10);  // unknown to the library so far
    std::vector<Managed> before;
    for (std::size_t i = 0; i < 20; ++i) before.push_back(managed(scene.rotation(), *scene.bodies()[i]));
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    const bool has_thrown = throws_bad_alloc([&] { call(scene); });
    const bool has_failed = shortage.end();
    EXPECT_EQ(has_thrown, has_failed) << granted;
    if (has_failed) {
      for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_TRUE(same(managed(scene.rotation(), *scene.bodies()[i]), before[i])) << granted << " " << i;
      }
      EXPECT_EQ(scene.rotation().managed_bodies(), 30u) << granted;
      expect_choice(scene, *scene.bodies()[5], before[5]);
      call(scene);
    }
    scene.step(kDt);
    return has_failed;
  });
}

template <class Way>
class AllocationFailure : public ::testing::Test {};
TYPED_TEST_SUITE(AllocationFailure, BothWays, WayName);

TYPED_TEST(AllocationFailure, CannotHappenWhileBodiesAreAdded) {
  TypeParam scene;
  add_free_bodies(scene, 20);
  btDynamicsWorld& world = scene.world();
  for (const auto& body : scene.bodies()) world.removeRigidBody(body.get());
  const std::size_t before = heap_allocations();
  for (const auto& body : scene.bodies()) world.addRigidBody(body.get());
  for (const auto& body : scene.bodies()) world.removeRigidBody(body.get());
  for (const auto& body : scene.bodies()) world.addRigidBody(body.get(), 1, -1);
  EXPECT_EQ(heap_allocations(), before);
}

TYPED_TEST(AllocationFailure, LeavesTheSchemeOfABody) {
  const std::size_t refused = expect_all_or_nothing<TypeParam>([](TypeParam& scene) {
    scene.rotation().set_scheme(*scene.bodies()[5], "quaternion");
    EXPECT_EQ(scene.rotation().rotation_of(*scene.bodies()[5]).scheme, "quaternion");
  });
  EXPECT_GE(refused, 8u);  // measured 10
}

TYPED_TEST(AllocationFailure, LeavesTheDefaultScheme) {
  const std::size_t refused = expect_all_or_nothing<TypeParam>([](TypeParam& scene) {
    scene.rotation().set_default_scheme("matrix");
    EXPECT_EQ(scene.rotation().rotation_of(*scene.bodies()[5]).scheme, "matrix");
  });
  EXPECT_GE(refused, 10u);  // measured 16
}

TYPED_TEST(AllocationFailure, LeavesABodyThatWasToBeReleased) {
  expect_all_or_nothing<TypeParam>([](TypeParam& scene) {
    scene.rotation().release(*scene.bodies()[5]);
    EXPECT_FALSE(scene.rotation().manages(*scene.bodies()[5]));
    scene.rotation().use_default_scheme(*scene.bodies()[5]);
  });
}

TYPED_TEST(AllocationFailure, LeavesABodyThatWasToBeDriven) {
  const TorqueLaw law = [](const TorqueLawInput&) { return Torque(); };
  const std::size_t refused = expect_all_or_nothing<TypeParam>([&law](TypeParam& scene) {
    btRigidBody& body = *scene.bodies()[5];
    scene.rotation().set_rotor_momentum(body, {0.0, 0.0, 0.5}, RotorChange::by_motor);
    EXPECT_TRUE(scene.rotation().rotation_of(body).state.has_rotor());
    scene.rotation().set_torque_law(body, law);
  });
  EXPECT_GE(refused, 8u);
}

TYPED_TEST(AllocationFailure, LeavesABodyThatWasToBeRestored) {
  TypeParam other;
  add_free_bodies(other, 1);
  other.rotation().set_scheme(*other.bodies()[0], "rk4");
  other.step(kDt, 3);
  const Snapshot snapshot = other.rotation().save(*other.bodies()[0]);
  const std::size_t refused = expect_all_or_nothing<TypeParam>(
      [&snapshot](TypeParam& scene) { scene.rotation().restore(*scene.bodies()[5], snapshot); });
  EXPECT_GT(refused, 0u);
}

TYPED_TEST(AllocationFailure, LeavesTheIncidentHandler) {
  const std::array<char, 100> large{};  // too large for the small buffer of std::function
  expect_all_or_nothing<TypeParam>([&](TypeParam& scene) {
    scene.rotation().set_incident_handler([large](const Incident&) { EXPECT_EQ(large[0], 0); });
  });
}

// Adds and removes bodies and joints and changes schemes. Some bodies are in contact, on hinges, or have a
// locked axis.
template <class Way>
class EventfulScene : public Way {
 public:
  EventfulScene() {
    this->world().setGravity(btVector3(0, 0, -10));
    this->add_floor();
    std::vector<std::pair<btRigidBody*, const char*>> schemes;
    for (int i = 0; i < 3; ++i) {
      add_at(btVector3(btScalar(3 * i), 0, btScalar(0.99)));
      btRigidBody& hinged = add_at(btVector3(btScalar(3 * i), 20, 20));
      hinge_ = &this->template join<btHingeConstraint>(hinged, btVector3(0, 0, 0), btVector3(0, 1, 1));
      schemes.emplace_back(&hinged, i == 1 ? "implicit_gyroscopic" : i == 2 ? "quaternion" : "exact");
      add_at(btVector3(btScalar(3 * i), 40, 40)).setAngularFactor(btVector3(1, 1, 0));
    }
    for (int i = 0; i < 8; ++i) add_at(btVector3(btScalar(5 * i), 60, 60));
    watched_ = &add_at(btVector3(0, 80, 80));
    // Fills the last batch of `exact` when another body is replaced.
    for (int i = 0; i < 9; ++i) {
      late_.push_back(&add_at(btVector3(btScalar(5 * i), 100, 100)));
      this->world().removeRigidBody(late_.back());
    }
    replaced_.emplace(info_of_replaced());
    schemes.emplace_back(watched_, "exact");
    for (const auto& [body, scheme] : schemes) this->rotation().set_scheme(*body, scheme);
  }
  ~EventfulScene() { this->world().removeRigidBody(&*replaced_); }

  static constexpr int kSteps = 14;

  void play() {
    for (int step = 0; step < kSteps; ++step) {
      change(step);
      this->step(kDt);
    }
  }
  bool all_are_finite() const {
    for (const auto& body : this->bodies()) {
      if (!is_finite(*body)) return false;
    }
    return true;
  }
  /// A free body that stays in the world throughout.
  const btRigidBody& watched() const { return *watched_; }
  const btRigidBody& replaced() const { return *replaced_; }
  std::size_t dynamic_bodies() {
    return static_cast<std::size_t>(this->world().getNonStaticRigidBodies().size());
  }

 private:
  btRigidBody& add_at(const btVector3& origin) {
    btRigidBody& body = this->add(1, btVector3(1, 2, 3), btTransform(btQuaternion::getIdentity(), origin),
                                  this->box(btVector3(1, 1, 1)));
    body.setAngularVelocity(btVector3(5, 4, 3));
    body.setCcdMotionThreshold(origin.z() > 50 ? btScalar(0.01) : btScalar(0));
    return body;
  }
  btRigidBody::btRigidBodyConstructionInfo info_of_replaced() {
    btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &this->box(btVector3(1, 1, 1)),
                                                  btVector3(1, 2, 3));
    info.m_startWorldTransform.setOrigin(btVector3(0, 120, 120));
    return info;
  }
  void change(int step) {
    btDynamicsWorld& world = this->world();
    RotationControl& rotation = this->rotation();
    btRigidBody& first = *this->bodies()[1];
    switch (step) {
      case 2:
        for (btRigidBody* body : late_) world.addRigidBody(body);
        break;
      case 4:
        world.removeRigidBody(&first);
        break;
      case 5:
        throws_bad_alloc([&] { rotation.set_scheme(*late_[0], "matrix"); });
        break;
      case 6:
        world.addRigidBody(&first);
        world.addRigidBody(&*replaced_);
        break;
      case 7:
        hinge_->setEnabled(false);
        break;
      case 8: {
        throws_bad_alloc([&] { rotation.release(*replaced_); });
        break;
      }
      case 9: {
        // Another body at the same address.
        const btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, replaced_->getCollisionShape(),
                                                            btVector3(3, 2, 1));
        world.removeRigidBody(&*replaced_);
        replaced_.emplace(info);
        replaced_->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 120, 120)));
        replaced_->setAngularVelocity(btVector3(1, 2, 3));
        world.addRigidBody(&*replaced_);
        break;
      }
      case 11:
        throws_bad_alloc([&] { rotation.set_default_scheme("implicit_midpoint"); });
        break;
      default:
        break;
    }
  }

  btHingeConstraint* hinge_ = nullptr;
  btRigidBody* watched_ = nullptr;
  std::vector<btRigidBody*> late_;
  std::optional<btRigidBody> replaced_;
};

// Returns the number of failed allocations. Known bodies must be unaffected by failures.
template <class Way>
std::size_t play_eventful_scene(MemoryReturns returns) {
  EventfulScene<Way> undisturbed;
  undisturbed.play();
  return refuse_each_allocation([&](std::size_t granted) {
    const std::size_t blocks_before = heap_blocks();
    bool has_failed = false;
    {
      EventfulScene<Way> scene;
      MemoryShortage shortage(granted, returns);
      scene.play();
      has_failed = shortage.end();
      EXPECT_TRUE(scene.all_are_finite()) << granted;
      EXPECT_TRUE(same_bits(scene.watched(), undisturbed.watched())) << granted;
      scene.step(kDt, 3);
      EXPECT_TRUE(scene.all_are_finite()) << granted;
      EXPECT_EQ(scene.rotation().managed_bodies(), scene.dynamic_bodies()) << granted;
      EXPECT_EQ(scene.rotation().incidents(), 0u) << granted;
    }
    EXPECT_EQ(heap_blocks(), blocks_before) << granted;
    return has_failed;
  });
}

TYPED_TEST(AllocationFailure, DoesNotEndAStepWhenOneAllocationFails) {
  EXPECT_GE(play_eventful_scene<TypeParam>(MemoryReturns::at_once), 100u);  // measured 207
}

TYPED_TEST(AllocationFailure, DoesNotEndTheStepsWithoutMemory) {
  EXPECT_GE(play_eventful_scene<TypeParam>(MemoryReturns::when_told), 100u);  // measured 207
}

TYPED_TEST(AllocationFailure, LeavesIncidentsToBeReportedOnce) {
  const std::size_t refused = refuse_each_allocation([](std::size_t granted) {
    TypeParam scene;
    add_free_bodies(scene, 20);
    scene.step(kDt);
    std::array<int, 20> heard{};
    scene.rotation().set_incident_handler([&](const Incident& incident) {
      for (std::size_t i = 0; i < 20; ++i) heard[i] += scene.bodies()[i].get() == incident.body ? 1 : 0;
    });
    scene.rotation().set_scheme(*scene.bodies()[3], "matrix");
    scene.step(kDt);
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    scene.bodies()[3]->setAngularVelocity(btVector3(btScalar(1e9), 0, 0));
    for (std::size_t i = 10; i < 20; ++i) {
      scene.bodies()[i]->setAngularVelocity(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
    }
    scene.step(kDt, 2);
    const bool has_failed = shortage.end();
    scene.step(kDt);
    EXPECT_EQ(scene.rotation().incidents(), 11u);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(heard[i], i == 3 || i >= 10 ? 1 : 0) << i;
    return has_failed;
  });
  EXPECT_EQ(refused, 0u);  // a report allocates no memory
}

// Each thread that steps bodies has its own scratch object. If one cannot be allocated, a spare is used.
TEST(AllocationFailureOfAScratchObject, ChangesNoBit) {
  Scene<> undisturbed;
  add_free_bodies(undisturbed, 20);
  RotationPlugin plugin(undisturbed.world());
  for (const auto& body : undisturbed.bodies()) body->setDamping(0, btScalar(0.1));
  undisturbed.step(kDt, 10);
  int without_scratch_object = 0;
  refuse_each_allocation([&](std::size_t granted) {
    Scene<> scene;
    add_free_bodies(scene, 20);
    for (const auto& body : scene.bodies()) body->setDamping(0, btScalar(0.1));
    MemoryShortage at_configuration(granted, MemoryReturns::at_once);
    std::optional<RotationPlugin> attached;
    const bool has_thrown = throws_bad_alloc([&] { attached.emplace(scene.world()); });
    const bool has_failed = at_configuration.end();
    if (has_thrown || !has_failed) return has_failed;
    ++without_scratch_object;
    MemoryShortage in_the_steps(0, MemoryReturns::when_told);
    scene.step(kDt, 10);
    EXPECT_TRUE(in_the_steps.end());
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_TRUE(same_bits(*scene.bodies()[i], *undisturbed.bodies()[i])) << i;
    }
    return true;
  });
  EXPECT_EQ(without_scratch_object, 1);
}

// Removes a body from the world after the solver has run.
class RemovingWorld : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void solveConstraints(btContactSolverInfo& info) override {
    btDiscreteDynamicsWorld::solveConstraints(info);
    if (to_remove == nullptr) return;
    removeRigidBody(to_remove);
    to_remove = nullptr;
    shortage.emplace(granted, MemoryReturns::when_told);
  }
  btRigidBody* to_remove = nullptr;
  std::size_t granted = 0;
  std::optional<MemoryShortage> shortage;
};

// The last body fills the hole in another batch. The solver has been given a gyroscopic term for the last
// body, which no body of the other batch has.
void remove_in_the_solve(const char* scheme, const btVector3& angular_factor) {
  const std::size_t refused = refuse_each_allocation([&](std::size_t granted) {
    Scene<RotationWorld<RemovingWorld>> scene;
    scene.world().rotation().set_default_scheme(scheme);
    add_free_bodies(scene, 9);
    btRigidBody& last = *scene.bodies().back();
    last.setAngularFactor(angular_factor);
    scene.join<btHingeConstraint>(last, btVector3(0, 0, 0), btVector3(0, 1, 1));
    scene.world().to_remove = scene.bodies().front().get();
    scene.world().granted = granted;
    scene.step(kDt);
    const bool has_failed = scene.world().shortage->end();
    scene.step(kDt, 60);
    EXPECT_TRUE(is_finite(last));
    EXPECT_LT(last.getAngularVelocity().length(), btScalar(5.5)) << scheme;
    EXPECT_EQ(scene.world().rotation().rotation_of(last).steps, 61u);
    EXPECT_EQ(scene.world().rotation().incidents(), 0u);
    return has_failed;
  });
  EXPECT_EQ(refused, 1u) << scheme;
}

TEST(AllocationFailureInTheSolve, LosesTheGyroscopicTermButNoBody) {
  remove_in_the_solve("exact", btVector3(1, 1, 1));
  remove_in_the_solve("implicit_gyroscopic", btVector3(1, 1, 1));
  remove_in_the_solve("exact", btVector3(1, 1, 0));
}

// Lets each allocation of make(world) fail in turn. After a failure the world must be free for others.
template <class Make>
std::size_t attach_with_each_allocation_refused(const Make& make) {
  return refuse_each_allocation([&](std::size_t granted) {
    Scene<> scene;
    add_free_bodies(scene, 20);
    const btSimulationIslandManager* manager = scene.world().getSimulationIslandManager();
    const std::size_t blocks_before = heap_blocks();
    std::unique_ptr<RotationPlugin> plugin;
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    const bool has_thrown = throws_bad_alloc([&] { plugin = make(scene.world()); });
    const bool has_failed = shortage.end();
    EXPECT_EQ(has_thrown, has_failed) << granted;
    if (has_failed) {
      EXPECT_EQ(scene.world().getSimulationIslandManager(), manager);
      EXPECT_EQ(heap_blocks(), blocks_before) << granted;
      scene.step(kDt);
      plugin = make(scene.world());
    }
    EXPECT_EQ(plugin->rotation().managed_bodies(), 20u);
    return has_failed;
  });
}

TEST(AllocationFailureOfAPlugin, LeavesTheWorldWithoutIt) {
  const std::size_t refused = attach_with_each_allocation_refused(
      [](btDynamicsWorld& world) { return std::make_unique<RotationPlugin>(world); });
  EXPECT_GE(refused, 10u);  // measured 23
}

TEST(AllocationFailureOfAPlugin, LeavesItDetached) {
  refuse_each_allocation([&](std::size_t granted) {
    Scene<> scene;
    add_free_bodies(scene, 20);
    RotationPlugin plugin(scene.world());
    plugin.detach();
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    const bool has_thrown = throws_bad_alloc([&] { plugin.attach(); });
    const bool has_failed = shortage.end();
    EXPECT_EQ(has_thrown, has_failed) << granted;
    EXPECT_EQ(plugin.attached(), !has_failed) << granted;
    if (has_failed) {
      RotationPlugin other(scene.world());
      EXPECT_TRUE(other.attached());
    }
    plugin.attach();
    EXPECT_EQ(plugin.rotation().managed_bodies(), 20u);
    return has_failed;
  });
}

TEST(AllocationFailureOfAPlugin, LeavesTheOneThatIsThere) {
  Scene<> scene;
  add_free_bodies(scene, 20);
  const RotationPlugin first(scene.world());
  refuse_each_allocation([&](std::size_t granted) {
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    const auto make_second = [&] { const RotationPlugin second(scene.world()); };
    bool is_refused = false;
    const bool has_thrown = throws_bad_alloc([&] {
      try {
        make_second();
      } catch (const std::invalid_argument&) {
        is_refused = true;
      }
    });
    const bool has_failed = shortage.end();
    EXPECT_TRUE(has_thrown || is_refused) << granted;
    EXPECT_TRUE(first.attached());
    EXPECT_EQ(first.rotation().managed_bodies(), 20u);
    return has_failed;
  });
}

TEST(AllocationFailureOfARotationWorld, LeavesNothingOfIt) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  using World = RotationWorld<btDiscreteDynamicsWorld>;
  std::optional<World> world;
  const auto make = [&] { world.emplace(&dispatcher, &broadphase, &solver, &configuration); };
  make();  // the library's list of worlds keeps its capacity
  world.reset();
  const std::size_t blocks_before = heap_blocks();
  const std::size_t refused = refuse_each_allocation([&](std::size_t granted) {
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    const bool has_thrown = throws_bad_alloc(make);
    const bool has_failed = shortage.end();
    if (has_thrown) {
      EXPECT_EQ(heap_blocks(), blocks_before);
      make();
    }
    world.reset();
    EXPECT_EQ(heap_blocks(), blocks_before);
    return has_failed;
  });
  EXPECT_GE(refused, 2u);
}

}  // namespace
}  // namespace polhode::testing
