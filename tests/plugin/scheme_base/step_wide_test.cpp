// Steps eight bodies in one call: each gets the bits of a step of its own, whatever the other lanes contain.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/random_body.h"
#include "support/same_bits.h"
#include "support/wide_batch.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;
using testing::WideBatch;

constexpr double kDt = 1.0 / 60.0;

struct Body {
  StepInput input;
  RotationState state;
};

/// Free and kicked bodies, with dt forwards and backwards, at rest, fast, and some with invalid data.
std::vector<Body> all_bodies() {
  RandomBody random(31);
  std::vector<Body> bodies;
  for (int i = 0; i < 40; ++i) {
    Body body{{random.inertia_B(), Vector3::Zero(), i % 5 == 4 ? -kDt : kDt}, {}};
    set_orientation(body.state, random.q_WB());
    set_omega(body.state, body.input.inertia_B, i % 7 == 3 ? Vector3(Vector3::Zero()) : random.omega_W());
    if (i % 3 == 1) body.input.delta_omega_W = random.omega_W();
    bodies.push_back(body);
  }
  bodies[5].state.omega_W.x() = std::nan("");
  bodies[9].state.L_W.y() = std::numeric_limits<double>::infinity();
  set_omega(bodies[14].state, bodies[14].input.inertia_B, Vector3(1e200, 1e200, -1e200));
  set_omega(bodies[20].state, bodies[20].input.inertia_B, Vector3(2e3, -1e3, 3e3));
  bodies[22].state.R_WB *= Vector3(1.0, 300.0, 20.0).asDiagonal();
  bodies[26].state.R_WB.setZero();
  bodies[27].input.dt = 0.0;
  return bodies;
}

Body rubbish(std::size_t i) {
  const double value = std::array<double, 4>{std::nan(""), HUGE_VAL, 0.0, 5e-324}[i % 4];
  Body body{{Vector3::Constant(value), Vector3::Constant(value), value}, {}};
  body.state.q_WB.coeffs().setConstant(value);
  body.state.R_WB.setConstant(value);
  body.state.omega_W.setConstant(value);
  body.state.L_W.setConstant(value);
  return body;
}

std::vector<SchemePointer> wide_schemes() {
  std::vector<SchemePointer> found;
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (dynamic_cast<const WideScheme*>(scheme.get()) != nullptr) found.push_back(scheme);
  }
  return found;
}

class StepWide : public ::testing::TestWithParam<SchemePointer> {
 protected:
  const WideScheme& scheme() { return dynamic_cast<const WideScheme&>(*GetParam()); }

  // Bodies in the lanes of the mask, garbage in the others.
  static WideBatch batch_of(const WideScheme& scheme, std::bitset<kLanes> mask, std::size_t first) {
    static const std::vector<Body> bodies = all_bodies();
    WideBatch batch(scheme);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Body body = mask[lane] ? bodies[(first + lane) % bodies.size()] : rubbish(first + lane);
      batch.put(lane, body.input, body.state);
    }
    return batch;
  }
};

TEST_P(StepWide, OfAnyMaskIsTheStepOfEachBody) {
  for (unsigned mask = 0; mask < 256; ++mask) {
    WideBatch batch = batch_of(scheme(), mask, mask * 3);
    const WideBatch start = batch;
    scheme().step_wide(batch.input, WideMask::from_bits(mask), batch.state, nullptr);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!std::bitset<kLanes>(mask)[lane]) continue;
      StepInput input;
      get_lane(lane, start.input, input);
      RotationState alone = start.state_of(lane);
      scheme().step(input, alone);
      ASSERT_TRUE(same_bits(batch.state_of(lane), alone)) << mask << " lane " << lane;
    }
  }
}

TEST_P(StepWide, LeavesTheMemoryOutsideItsMask) {
  for (unsigned mask = 0; mask < 256; ++mask) {
    WideBatch batch = batch_of(scheme(), mask, mask * 3);
    std::vector<double> odd;
    for (std::size_t row = 0; row < batch.memory.size(); ++row) {
      odd.push_back(row % 3 == 0 ? std::nan("") : 0.1 * static_cast<double>(row));
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!std::bitset<kLanes>(mask)[lane]) batch.set_memory(lane, odd);
    }
    for (int step = 0; step < 3; ++step) {
      scheme().step_wide(batch.input, WideMask::from_bits(mask), batch.state, batch.memory.data());
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (std::bitset<kLanes>(mask)[lane]) continue;
      const std::vector<double> left = batch.memory_of(lane);
      for (std::size_t row = 0; row < odd.size(); ++row) {
        ASSERT_TRUE(same_bits(left[row], odd[row])) << mask << " lane " << lane << " row " << row;
      }
    }
  }
}

TEST_P(StepWide, TurnsEachBodyAsItsTurnDoes) {
  const std::vector<Body> bodies = all_bodies();
  for (std::size_t first = 0; first + kLanes <= bodies.size(); ++first) {
    WideBatch batch = batch_of(scheme(), 255, first);
    const WideBatch start = batch;
    scheme().turn_wide(start.state.omega_W, start.input.dt, batch.state);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      RotationState alone = start.state_of(lane);
      scheme().turn(alone.omega_W, start.input.dt[lane], alone);
      ASSERT_TRUE(same_bits(batch.state_of(lane), alone)) << first << " lane " << lane;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, StepWide, ::testing::ValuesIn(wide_schemes()),
                         [](const auto& scheme) { return std::string(scheme.param->description().name); });

}  // namespace
}  // namespace polhode
