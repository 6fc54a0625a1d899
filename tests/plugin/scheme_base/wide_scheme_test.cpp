// A single body passes through the lanes of a WideScheme and back.
#include "scheme_base/wide_scheme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

// A formula that involves every input and every part of the state, for doubles and for wide numbers.
template <class Input, class State>
void change(const Input& input, State& state) {
  state.q_WB.coeffs() *= input.dt;
  state.R_WB *= input.dt;
  state.omega_W += input.delta_omega_W;
  state.L_W += input.inertia_B;
}

class Changing final : public WideScheme {
 public:
  SchemeDescription description() const noexcept override { return {"changing", "", "", ""}; }
  std::size_t memory_rows() const noexcept override { return 1; }
  void step_wide(const WideStepInput& input, const WideMask& mask, WideState& state,
                 WideMemoryRow* memory) const noexcept override {
    EXPECT_EQ(mask.bits(), 1U);
    EXPECT_EQ(memory, nullptr);
    change(input, state);
  }
};

struct Body {
  explicit Body(RandomBody& random)
      : input{random.inertia_B(), random.omega_W(), random.omega_W().x()},
        state{random.q_WB(), random.q_WB().toRotationMatrix(), random.omega_W(), random.omega_W()} {}

  StepInput input;
  RotationState state;
};

TEST(WideScheme, StepsOneBodyWithoutAMemory) {
  RandomBody random(7);
  for (int i = 0; i < 20; ++i) {
    const Body body(random);
    RotationState expected = body.state;
    change(body.input, expected);
    RotationState stepped = body.state;
    Changing().step(body.input, stepped);
    EXPECT_TRUE(same_bits(stepped, expected));
  }
}

TEST(WideScheme, TurnsByTheExponentialUnlessItSaysOtherwise) {
  class OneBody final : public RotationScheme {
   public:
    SchemeDescription description() const noexcept override { return {"one body", "", "", ""}; }
    void step(const StepInput& /*input*/, RotationState& /*state*/) const noexcept override {}
  };
  RandomBody random(8);
  for (int i = 0; i < 100; ++i) {
    const Body body(random);
    RotationState expected = body.state;
    set_orientation(expected, exponential(body.input.dt * body.input.delta_omega_W) * body.state.q_WB);
    RotationState turned = body.state;
    Changing().turn(body.input.delta_omega_W, body.input.dt, turned);
    // Rounding of the angle, which is up to 10,000 rad.
    const double rounding = 3e-16 * (2.0 + std::abs(body.input.dt) * body.input.delta_omega_W.norm());
    EXPECT_LE((turned.q_WB.coeffs() - expected.q_WB.coeffs()).norm(), rounding);
    EXPECT_EQ(turned.R_WB, turned.q_WB.toRotationMatrix());
    RotationState turned_alone = body.state;
    OneBody().turn(body.input.delta_omega_W, body.input.dt, turned_alone);
    EXPECT_LE((turned_alone.q_WB.coeffs() - expected.q_WB.coeffs()).norm(), rounding);
  }
}

TEST(WideState, PutsAndGetsTheStepOfOneLane) {
  RandomBody random(9);
  std::vector<Body> bodies;
  WideStepInput inputs;
  WideState states;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    bodies.emplace_back(random);
    set_lane(lane, bodies[lane].input, inputs);
    set_lane(lane, bodies[lane].state, states);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    StepInput input;
    RotationState state;
    get_lane(lane, inputs, input);
    get_lane(lane, states, state);
    EXPECT_TRUE(same_bits(state, bodies[lane].state)) << lane;
    EXPECT_TRUE(same_bits(input.inertia_B, bodies[lane].input.inertia_B)) << lane;
    EXPECT_TRUE(same_bits(input.delta_omega_W, bodies[lane].input.delta_omega_W)) << lane;
    EXPECT_TRUE(same_bits(input.dt, bodies[lane].input.dt)) << lane;
  }
}

}  // namespace
}  // namespace polhode
