// Bodies into lanes and back.
#include "lanes/lane_block.h"

#include <gtest/gtest.h>

#include <vector>

#include "lanes/lane_step.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

constexpr std::size_t kMost = 20;

// More bodies than are stepped, so that what happens past the last of them shows.
struct Bodies {
  Bodies() {
    RandomBody random(7);
    for (std::size_t i = 0; i < kMost + kLanes; ++i) {
      const double dt = 0.01 * (1.0 + 0.1 * static_cast<double>(i));
      inputs.push_back({random.inertia_B(), random.omega_W(), dt, 0.5 * dt});
      states.push_back({random.q_WB(), random.q_WB().toRotationMatrix(), random.omega_W(), random.omega_W()});
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) steps.push_back({&inputs[i], &states[i], nullptr});
  }

  std::vector<StepInput> inputs;
  std::vector<RotationState> states;
  std::vector<BodyStep> steps;
};

// Something that every input and every part of the state has a part in, for doubles or for lanes.
template <class Input, class State>
void change(const Input& input, State& state) {
  state.q_WB.coeffs() *= input.dt;
  state.R_WB *= input.turn_dt;
  state.omega_W += input.delta_omega_W;
  state.L_W += input.inertia_B;
}

TEST(LaneBlock, GivesEachBodyItsOwnAndLeavesTheRestAlone) {
  for (std::size_t count = 0; count <= kMost; ++count) {
    Bodies bodies;
    Bodies expected;
    for (std::size_t i = 0; i < count; ++i) change(expected.inputs[i], expected.states[i]);
    step_in_lanes(bodies.steps.data(), count,
                  [](const LaneInput& input, LaneState& state) { change(input, state); });
    for (std::size_t i = 0; i < bodies.states.size(); ++i) {
      EXPECT_TRUE(same_bits(bodies.states[i], expected.states[i])) << i << " of " << count;
    }
  }
}

TEST(LaneBlock, CountsItsBodiesAndFillsUpWithTheLast) {
  Bodies bodies;
  std::vector<std::size_t> counts;
  in_blocks(bodies.steps.data(), kMost, [&](const LaneBlock& block) {
    counts.push_back(block.count());
    for (std::size_t lane = block.count(); lane < kLanes; ++lane) {
      EXPECT_EQ(block.body(lane).state, block.body(block.count() - 1).state);
    }
  });
  EXPECT_EQ(counts, (std::vector<std::size_t>{8, 8, 4}));
}

}  // namespace
}  // namespace polhode
