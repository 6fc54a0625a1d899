// The library's own loops run on the threads of Bullet's scheduler.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "multithreading/mt_scene.h"
#include "multithreading/run.h"
#include "multithreading/schedulers.h"
#include "polhode/bullet/rotation_world.h"
#include "support/motion.h"

namespace polhode::testing {
namespace {

constexpr int kBodies = 2000;
constexpr int kRecordedSteps = 10;

// Rotates like `exact` and records the threads used.
class ThreadRecorder final : public RotationScheme {
 public:
  SchemeDescription description() const noexcept override {
    return {"thread_recorder", "exact, and records the threads", "this test", "never"};
  }
  void step(const StepInput& input, RotationState& state) const noexcept override {
    exact_->step(input, state);
    ++steps_;
    const std::lock_guard<std::mutex> lock(mutex_);
    threads_.insert(std::this_thread::get_id());
  }
  std::set<std::thread::id> threads() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return threads_;
  }
  int steps() const { return steps_; }

 private:
  SchemePointer exact_ = find_scheme("exact");
  mutable std::atomic<int> steps_{0};
  mutable std::mutex mutex_;
  mutable std::set<std::thread::id> threads_;
};

std::shared_ptr<const ThreadRecorder> recorded(Way way) {
  auto recorder = std::make_shared<const ThreadRecorder>();
  MtScene scene(way, {true, true});
  scene.rotation().set_default_scheme(recorder);
  btCollisionShape& shape = scene.box(btVector3(1, 1, 1));
  for (int i = 0; i < kBodies; ++i) {
    const btTransform pose(btQuaternion::getIdentity(), vector(10 * (i % 50), 10 * (i / 50), 0));
    btRigidBody& body = scene.add(1, btVector3(1, 2, 3), pose, shape);
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setAngularVelocity(btVector3(1, 2, 1));
  }
  for (int step = 0; step < kRecordedSteps; ++step) scene.step(btScalar(1.0 / 60.0));
  return recorder;
}

class LoopsInMt : public ::testing::TestWithParam<Way> {};

TEST_P(LoopsInMt, RunOnMoreThanOneThread) {
  const ActiveScheduler active(four_threads().make());
  const auto recorder = recorded(GetParam());
  EXPECT_GT(recorder->threads().size(), 1u);
  EXPECT_LE(recorder->threads().size(), 4u);
}

TEST_P(LoopsInMt, StepEachBodyOncePerStep) {
  const ActiveScheduler active(four_threads().make());
  EXPECT_EQ(recorded(GetParam())->steps(), kBodies * kRecordedSteps);
}

TEST_P(LoopsInMt, StayInTheThreadOfTheCallerUnderBulletsSequentialScheduler) {
  const ActiveScheduler active({btGetSequentialTaskScheduler(), [](btITaskScheduler*) {}});
  EXPECT_EQ(recorded(GetParam())->threads(), std::set<std::thread::id>{std::this_thread::get_id()});
}

INSTANTIATE_TEST_SUITE_P(Threads, LoopsInMt, ::testing::Values(Way::rotation_world, Way::rotation_plugin),
                         [](const auto& parameter) { return to_string(parameter.param); });

// An application may link a thread-safe Bullet without setting a scheduler: btParallelFor then has no
// scheduler to call.
TEST(LoopsWithoutAScheduler, StayInTheThreadOfTheCaller) {
  ASSERT_EQ(btGetTaskScheduler(), nullptr);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  RotationWorld<btDiscreteDynamicsWorld> world(&dispatcher, &broadphase, &solver, &configuration);
  const auto recorder = std::make_shared<const ThreadRecorder>();
  world.rotation().set_default_scheme(recorder);
  btBoxShape shape(btVector3(1, 1, 1));
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  for (int i = 0; i < kBodies; ++i) {
    bodies.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, &shape, btVector3(1, 2, 3)));
    bodies.back()->setCenterOfMassTransform(
        btTransform(btQuaternion::getIdentity(), vector(10 * (i % 50), 10 * (i / 50), 0)));
    world.addRigidBody(bodies.back().get());
  }
  world.stepSimulation(btScalar(1.0 / 60.0), 0);
  EXPECT_EQ(recorder->threads(), std::set<std::thread::id>{std::this_thread::get_id()});
  for (const auto& body : bodies) world.removeRigidBody(body.get());
}

}  // namespace
}  // namespace polhode::testing
