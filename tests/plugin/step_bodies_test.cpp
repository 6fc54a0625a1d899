// Several bodies in one call: each comes out as from a call of its own, to the last bit, in whatever company.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

constexpr double kDt = 1.0 / 60.0;
constexpr std::size_t kMost = 37;

struct Bodies {
  std::vector<RotationState> states;
  std::vector<SchemeMemory> memories;
};

class StepBodies : public ::testing::TestWithParam<SchemePointer> {
 protected:
  StepBodies() {
    RandomBody random(31);
    for (std::size_t i = 0; i < kMost; ++i) {
      inertia_B_.push_back(random.inertia_B());
      RotationState state;
      set_orientation(state, random.q_WB());
      set_omega(state, inertia_B_[i], i % 7 == 3 ? Vector3(Vector3::Zero()) : random.omega_W());
      start_.states.push_back(state);
      kicks_W_.push_back(random.omega_W());
      torques_W_.push_back(random.omega_W());
    }
    add_odd_ones();
    start_.memories.resize(kMost);
    alone_ = start_;
    for (int step = 0; step < kSteps; ++step) {
      for (std::size_t i = 0; i < kMost; ++i) {
        scheme().step_with_memory(input(i, step), alone_.states[i], alone_.memories[i]);
      }
    }
  }

  const RotationScheme& scheme() { return *GetParam(); }

  // Free motion, kicks in some steps, torques of either kind, a step that ended early.
  StepInput input(std::size_t body, int step) const {
    StepInput result{inertia_B_[body], Vector3::Zero(), kDt, kDt};
    switch (body % 6) {
      case 1:
        if (step % 2 == 1) result.delta_omega_W = kicks_W_[body];
        break;
      case 2:
        result.torque_W = torques_W_[body];
        result.delta_omega_W = kDt * kicks_W_[body];
        result.torque_turns_with_body = body % 12 == 2;
        break;
      case 3:
        if (step == 2) result.turn_dt = 0.3 * kDt;
        break;
      case 4:
        if (body % 12 == 4) result.dt = result.turn_dt = 2.0 * kDt;
        break;
      default:
        break;
    }
    return result;
  }

  // Steps the bodies that `chosen` names, in that order and in calls of `count`; the others stay at the
  // start.
  Bodies step_together(const std::vector<std::size_t>& chosen, std::size_t count) {
    Bodies bodies = start_;
    for (int step = 0; step < kSteps; ++step) {
      std::vector<StepInput> inputs;
      for (const std::size_t i : chosen) inputs.push_back(input(i, step));
      std::vector<BodyStep> steps;
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        steps.push_back({&inputs[k], &bodies.states[chosen[k]], &bodies.memories[chosen[k]]});
      }
      for (std::size_t first = 0; first < steps.size(); first += count) {
        scheme().step_bodies(&steps[first], std::min(count, steps.size() - first));
      }
    }
    return bodies;
  }

  void expect_as_alone(const std::vector<std::size_t>& chosen, std::size_t count) {
    const Bodies together = step_together(chosen, count);
    for (std::size_t i = 0; i < kMost; ++i) {
      const bool stepped = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
      EXPECT_TRUE(same_bits(together.states[i], stepped ? alone_.states[i] : start_.states[i]))
          << "body " << i << ", in calls of " << count;
    }
  }

  static std::vector<std::size_t> first_bodies(std::size_t count) {
    std::vector<std::size_t> result(count);
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  Bodies start_;

 private:
  // A body that is no body, one whose velocity overflows, one much faster than a step, one swollen.
  void add_odd_ones() {
    start_.states[5].omega_W.x() = std::nan("");
    start_.states[9].L_W.y() = std::numeric_limits<double>::infinity();
    set_omega(start_.states[14], inertia_B_[14], Vector3(1e200, 1e200, -1e200));
    set_omega(start_.states[20], inertia_B_[20], Vector3(2e3, -1e3, 3e3));
    start_.states[22].R_WB *= Vector3(1.0, 300.0, 20.0).asDiagonal();
    start_.states[26].R_WB.setZero();
  }

  static constexpr int kSteps = 5;
  std::vector<Vector3> inertia_B_;
  std::vector<Vector3> kicks_W_;
  std::vector<Vector3> torques_W_;
  Bodies alone_;
};

TEST_P(StepBodies, DoesNotDependOnTheirNumber) {
  for (std::size_t count = 0; count <= kMost; ++count) expect_as_alone(first_bodies(count), kMost);
  for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 16u, 17u}) expect_as_alone(first_bodies(kMost), count);
}

TEST_P(StepBodies, DoesNotDependOnTheirCompanyOrOrder) {
  std::mt19937 generator(32);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::size_t> chosen = first_bodies(kMost);
    std::shuffle(chosen.begin(), chosen.end(), generator);
    chosen.resize(std::uniform_int_distribution<std::size_t>(1, kMost)(generator));
    expect_as_alone(chosen, kMost);
  }
}

// Schemes without a memory: step itself, too.
TEST_P(StepBodies, GivesWhatAStepGives) {
  for (std::size_t i = 0; i < kMost; ++i) {
    RotationState stepped = start_.states[i];
    scheme().step(input(i, 0), stepped);
    RotationState together = start_.states[i];
    SchemeMemory memory;
    const StepInput its_input = input(i, 0);
    const BodyStep body{&its_input, &together, &memory};
    scheme().step_bodies(&body, 1);
    EXPECT_TRUE(same_bits(stepped, together)) << "body " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, StepBodies, ::testing::ValuesIn(built_in_schemes()),
                         [](const auto& scheme) { return std::string(scheme.param->description().name); });

}  // namespace
}  // namespace polhode
