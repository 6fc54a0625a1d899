// A LaneScheme's bodies into lanes and back.
#include "lanes/lane_scheme.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

constexpr std::size_t kMost = 20;

// Something that every input and every part of the state has a part in, for doubles or for lanes.
template <class Input, class State>
void change(const Input& input, State& state) {
  state.q_WB.coeffs() *= input.dt;
  state.R_WB *= input.turn_dt;
  state.omega_W += input.delta_omega_W;
  state.L_W += input.inertia_B;
}

class Changing final : public LaneScheme {
 public:
  SchemeDescription description() const noexcept override { return {"changing", "", "", ""}; }
  void step_lanes(const LaneInput& input, LaneState& state,
                  const LaneMemories& memories) const noexcept override {
    change(input, state);
    for (std::size_t lane = 0; lane < memories.count; ++lane) ++memories.of[lane]->get<int>();
    for (std::size_t lane = memories.count; lane < kLanes; ++lane) {
      EXPECT_EQ(memories.of[lane], memories.of[memories.count - 1]);
    }
  }
};

// More bodies than are stepped, so that what happens past the last of them shows.
struct Bodies {
  Bodies() : memories(kMost + kLanes) {
    RandomBody random(7);
    for (std::size_t i = 0; i < memories.size(); ++i) {
      const double dt = 0.01 * (1.0 + 0.1 * static_cast<double>(i));
      inputs.push_back({random.inertia_B(), random.omega_W(), dt, 0.5 * dt});
      states.push_back({random.q_WB(), random.q_WB().toRotationMatrix(), random.omega_W(), random.omega_W()});
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) steps.push_back({&inputs[i], &states[i], &memories[i]});
  }

  std::vector<StepInput> inputs;
  std::vector<RotationState> states;
  std::vector<SchemeMemory> memories;
  std::vector<BodyStep> steps;
};

TEST(LaneScheme, GivesEachBodyItsOwnAndLeavesTheRestAlone) {
  for (std::size_t count = 0; count <= kMost; ++count) {
    Bodies bodies;
    Bodies expected;
    for (std::size_t i = 0; i < count; ++i) change(expected.inputs[i], expected.states[i]);
    Changing().step_bodies(bodies.steps.data(), count);
    for (std::size_t i = 0; i < bodies.states.size(); ++i) {
      EXPECT_TRUE(same_bits(bodies.states[i], expected.states[i])) << i << " of " << count;
      EXPECT_EQ(bodies.memories[i].get<int>(), i < count ? 1 : 0) << i << " of " << count;
    }
  }
}

TEST(LaneScheme, HasTheStepsOfOneBody) {
  Bodies bodies;
  RotationState expected = bodies.states[0];
  change(bodies.inputs[0], expected);
  RotationState stepped = bodies.states[0];
  Changing().step(bodies.inputs[0], stepped);
  EXPECT_TRUE(same_bits(stepped, expected));
  stepped = bodies.states[0];
  Changing().step_with_memory(bodies.inputs[0], stepped, bodies.memories[0]);
  EXPECT_TRUE(same_bits(stepped, expected));
  EXPECT_EQ(bodies.memories[0].get<int>(), 1);
}

TEST(LaneStep, PutsAndGetsTheStateOfOneLane) {
  const Bodies bodies;
  LaneState lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) set_lane(lane, bodies.states[lane], lanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    RotationState state;
    get_lane(lane, lanes, state);
    EXPECT_TRUE(same_bits(state, bodies.states[lane])) << lane;
  }
}

}  // namespace
}  // namespace polhode
