#include "benchmark/kernel_benchmark.h"

#include <btBulletDynamicsCommon.h>

#include <chrono>
#include <memory>
#include <vector>

#include "benchmark/paired_times.h"
#include "benchmark/scene_start.h"
#include "polhode/rotation_math.h"
#include "scheme_base/wide_scheme.h"
#include "world/conversions.h"

namespace polhode::benchmarks {

namespace {

constexpr std::size_t kBodies = 1024;
constexpr int kPassesPerRound = 4;
constexpr double kKick = 1e-3;  // rad/s

btVector3 inertia_of(const SceneStart& start, const BoxStart& box) {
  btVector3 inertia_B;
  btBoxShape(start.half_extents[box.shape]).calculateLocalInertia(box.mass_kg, inertia_B);
  return inertia_B;
}

/// A set of bodies; each pass steps every body once.
class Kernel {
 public:
  Kernel() = default;
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  virtual ~Kernel() = default;

  virtual void restart() = 0;
  /// `change` is the external change of omega_W, on each axis.
  virtual void pass(double change) = 0;
};

/// Only the part of Bullet's step that a scheme replaces. Bullet also updates the inertia tensor and the
/// interpolation poses, with or without the library.
class BulletKernel final : public Kernel {
 public:
  explicit BulletKernel(const SceneStart& start) : start_(start) {
    for (const BoxStart& box : start.boxes) {
      bodies_.push_back(std::make_unique<btRigidBody>(box.mass_kg, nullptr, nullptr, inertia_of(start, box)));
    }
  }

  void restart() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i]->setCenterOfMassTransform(start_.boxes[i].pose);
      bodies_[i]->setAngularVelocity(start_.boxes[i].omega_W);
    }
  }

  void pass(double change) override {
    const auto kick = static_cast<btScalar>(change);
    const btVector3 kick_W(kick, kick, kick);
    for (const auto& body : bodies_) {
      const btVector3 change_W = kick_W + body->computeGyroscopicImpulseImplicit_Body(kTimeStep);
      body->setAngularVelocity(body->getAngularVelocity() + change_W);
      btTransform turned;
      body->predictIntegratedTransform(kTimeStep, turned);
      body->setWorldTransform(turned);
    }
  }

 private:
  const SceneStart& start_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

RotationState state_of(const BoxStart& box, const Vector3& inertia_B) {
  RotationState state;
  set_orientation(state, Quaternion(demos::from_bullet(box.pose.getBasis())).normalized());
  set_omega(state, inertia_B, demos::from_bullet(box.omega_W));
  return state;
}

class SchemeKernel final : public Kernel {
 public:
  SchemeKernel(SchemePointer scheme, const SceneStart& start) : scheme_(std::move(scheme)) {
    for (const BoxStart& box : start.boxes) {
      const Vector3 inertia_B = demos::from_bullet(inertia_of(start, box));
      start_.push_back(state_of(box, inertia_B));
      inputs_.push_back({inertia_B, Vector3::Zero(), double(kTimeStep)});
    }
    states_ = start_;
  }

  void restart() override { states_ = start_; }

  void pass(double change) override {
    if (change != inputs_.front().delta_omega_W.x()) {
      for (StepInput& input : inputs_) input.delta_omega_W.setConstant(change);
    }
    for (std::size_t i = 0; i < states_.size(); ++i) scheme_->step(inputs_[i], states_[i]);
  }

 private:
  SchemePointer scheme_;
  std::vector<StepInput> inputs_;
  std::vector<RotationState> start_;
  std::vector<RotationState> states_;
};

/// Steps the bodies in batches of eight, as a RotationWorld does for a scheme of the library.
class WideKernel final : public Kernel {
 public:
  WideKernel(const WideScheme& scheme, const SceneStart& start)
      : scheme_(scheme),
        batches_(start.boxes.size() / kLanes),
        start_(batches_.size()),
        memory_(batches_.size() * scheme.memory_rows(), Wide(0.0)) {
    for (std::size_t i = 0; i < batches_.size() * kLanes; ++i) {
      const std::size_t lane = i % kLanes;
      const Vector3 inertia_B = demos::from_bullet(inertia_of(start, start.boxes[i]));
      set_lane(lane, StepInput{inertia_B, Vector3::Zero(), double(kTimeStep)}, batches_[i / kLanes].input);
      set_lane(lane, state_of(start.boxes[i], inertia_B), start_[i / kLanes]);
    }
  }

  void restart() override {
    for (std::size_t i = 0; i < batches_.size(); ++i) batches_[i].state = start_[i];
  }

  void pass(double change) override {
    const WideMask all = WideMask::from_bits((1U << kLanes) - 1);
    for (std::size_t i = 0; i < batches_.size(); ++i) {
      Batch& batch = batches_[i];
      batch.input.delta_omega_W.setConstant(Wide(change));
      scheme_.step_wide(batch.input, all, batch.state, memory_.data() + i * scheme_.memory_rows());
    }
  }

 private:
  struct Batch {
    WideStepInput input;
    WideState state;
  };

  const WideScheme& scheme_;
  std::vector<Batch> batches_;
  std::vector<WideState> start_;
  std::vector<WideMemoryRow> memory_;
};

/// Returns ns per body and step. Every round starts from the initial state, since some schemes diverge. Its
/// first pass warms up caches and scheme memories and is not timed.
double run_round(Kernel& kernel, double change) {
  kernel.restart();
  kernel.pass(-change);
  const auto before = std::chrono::steady_clock::now();
  for (int pass = 0; pass < kPassesPerRound; ++pass) kernel.pass(pass % 2 == 0 ? change : -change);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - before;
  return taken.count() / (kPassesPerRound * static_cast<double>(kBodies));
}

std::unique_ptr<Kernel> make_kernel(const SchemePointer& scheme, const SceneStart& start) {
  if (scheme == nullptr) return std::make_unique<BulletKernel>(start);
  if (const auto* wide = dynamic_cast<const WideScheme*>(scheme.get())) {
    return std::make_unique<WideKernel>(*wide, start);
  }
  return std::make_unique<SchemeKernel>(scheme, start);
}

}  // namespace

void run_kernel_benchmark(benchmark::State& state, const SchemePointer& scheme, KernelMotion motion) {
  const SceneStart start = free_flight(kBodies);
  const double change = motion == KernelMotion::set_up ? kKick : 0.0;
  BulletKernel bullet(start);
  const std::unique_ptr<Kernel> subject = make_kernel(scheme, start);
  PairedTimes times;
  bool bullet_first = true;
  while (state.KeepRunning()) {
    const double first_ns = run_round(bullet_first ? bullet : *subject, change);
    const double second_ns = run_round(bullet_first ? *subject : bullet, change);
    const double subject_ns = bullet_first ? second_ns : first_ns;
    times.add_round(bullet_first ? first_ns : second_ns, subject_ns);
    state.SetIterationTime(subject_ns * 1e-9);
    bullet_first = !bullet_first;
  }
  times.report(state);
}

}  // namespace polhode::benchmarks
