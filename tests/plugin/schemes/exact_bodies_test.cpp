// `exact` steps bodies in batches of eight: a body's result does not depend on its batch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"
#include "support/same_bits.h"
#include "support/wide_batch.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;
using testing::state_from;
using testing::WideBatch;

constexpr double kDt = 1.0 / 60.0;
constexpr int kSteps = 12;

const WideScheme& exact() {
  return dynamic_cast<const WideScheme&>(*find_scheme("exact"));
}

/// A body and the actions on it.
struct Body {
  std::string name;
  Vector3 inertia_B;
  RotationState state;
  double dt = kDt;
  Vector3 kick = Vector3::Zero();
  int kicked_every = 1;    // steps
  double swelling = 0.0;   // of the inertia, from the middle of the run on
  double faster_dt = 0.0;  // replaces dt in every third step
  int changed_every = 0;   // steps between changes of the state by the application
  std::vector<double> memory = std::vector<double>(exact().memory_rows(), 0.0);

  /// Applies the application's changes between two steps.
  void change(int step) {
    if (swelling != 0.0 && 2 * step == kSteps) memory.assign(memory.size(), 0.0);
    if (changed_every == 0 || step % changed_every != 0) return;
    state = state_from(inertia_B, state.q_WB, state.omega_W + Vector3(0.1, 0.0, -0.2));
  }

  StepInput input(int step) const {
    const double h = faster_dt != 0.0 && step % 3 == 2 ? faster_dt : dt;
    StepInput input{inertia_B, Vector3::Zero(), h};
    if (2 * step >= kSteps) input.inertia_B *= 1.0 + swelling;
    if (step % kicked_every == 0) input.delta_omega_W = kick;
    return input;
  }
};

/// Bodies of every kind, enough of each to fill batches in many ways.
std::vector<Body> all_kinds() {
  RandomBody random(23);
  std::vector<Body> bodies;
  const auto add = [&](const std::string& name, const Vector3& inertia_B, const Vector3& omega_W) -> Body& {
    Body body;
    body.name = name + " " + std::to_string(bodies.size());
    body.inertia_B = inertia_B;
    body.state = state_from(inertia_B, random.q_WB(), omega_W);
    bodies.push_back(body);
    return bodies.back();
  };
  // Slow enough for 1/60 s to be a short step whatever the random moments are.
  const auto add_slow = [&](const std::string& name) -> Body& {
    return add(name, Vector3(1, 2, 3) + 0.01 * random.inertia_B(), 3.0 * random.omega_W().normalized());
  };
  for (const Vector3& inertia_B : {Vector3(1, 2, 3), Vector3(1, 3, 2), Vector3(2, 1, 3), Vector3(2, 3, 1),
                                   Vector3(3, 1, 2), Vector3(3, 2, 1)}) {
    for (int axis = 0; axis < 3; ++axis) {
      add("every order of axes", inertia_B, Vector3(0.5, 0.6, 0.7) + 5.0 * Vector3::Unit(axis));
    }
  }
  for (int i = 0; i < 9; ++i) {
    add_slow("free");
    add_slow("kicked").kick = random.omega_W().normalized();
    add_slow("kicked at times").kick = random.omega_W().normalized();
    bodies.back().kicked_every = 2 + i % 3;
    add_slow("changed by others").changed_every = 3 + i % 2;
    add("random", random.inertia_B(), random.omega_W());
  }
  for (int i = 0; i < 3; ++i) {
    add("200 rad/s", Vector3(0.4, 0.5, 0.8), 200.0 * Vector3(5, 6, 6.2 + i).normalized());
    add("200 rad/s, kicked", Vector3(0.4, 0.5, 0.8), 200.0 * Vector3(5, 6, 6.2 + i).normalized()).kick =
        Vector3(1, 2, 3);
    add("a million rad a step", Vector3(1, 2, 3), 6e7 * Vector3(1, 0.2, 0.3 * i));
    add("at rest", Vector3(1, 2, 3), Vector3::Zero());
    add("from rest", Vector3(1, 2, 3), Vector3::Zero()).kick = Vector3(0.1, 2.0, 0.3 * i);
    add("near the separatrix", Vector3(1, 2, 3),
        Vector3(4.0, 2.8, 4.0 * std::sqrt(3.0) * (1.0 + std::pow(10.0, -5.0 * i)) / 3.0));
    add("about the middle axis", Vector3(1, 2, 3), Vector3(0, 5, i * 1e-9));
    add("spherical", Vector3(2, 2, 2), Vector3(1, 2, 3 + i));
    add("symmetric", Vector3(2, 2, 3), Vector3(1, 2, 3 + i));
    add_slow("another dt").dt = 0.003 * (i + 1);
    add_slow("dt that changes").faster_dt = 0.01;
    add_slow("backwards").dt = -kDt;
    add_slow("no time").dt = 0.0;
    add_slow("inertia that changes").swelling = 0.5;
    add("beyond double precision", Vector3(1, 2, 3), Vector3(1e200, 1e200, i));
  }
  return bodies;
}

/// Returns the states after each step, with each body stepped separately.
std::vector<std::vector<RotationState>> alone(std::vector<Body> bodies) {
  std::vector<std::vector<RotationState>> states(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    testing::RememberedBody body(exact());
    for (int step = 0; step < kSteps; ++step) {
      bodies[i].change(step);
      if (bodies[i].swelling != 0.0 && 2 * step == kSteps) body.forget();
      body.step(bodies[i].input(step), bodies[i].state);
      states[i].push_back(bodies[i].state);
    }
  }
  return states;
}

/// Steps up to eight bodies, bodies[chosen[0]] and so on, in lanes starting at `first`. The other lanes hold
/// another body and its memory, which must not matter.
void step_together(std::vector<Body>& bodies, const std::vector<std::size_t>& chosen, std::size_t first,
                   int step) {
  WideBatch batch(exact());
  std::bitset<kLanes> mask;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const std::size_t lane = (first + k) % kLanes;
    const Body& body = bodies[chosen[k % chosen.size()]];
    batch.put(lane, body.input(step), body.state);
    batch.set_memory(lane, body.memory);
    mask[lane] = k < chosen.size();
  }
  exact().step_wide(batch.input, WideMask::from_bits(mask), batch.state, batch.memory.data());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const std::size_t lane = (first + k) % kLanes;
    bodies[chosen[k]].state = batch.state_of(lane);
    bodies[chosen[k]].memory = batch.memory_of(lane);
  }
}

TEST(ExactBodies, GetTheSameBitsInAnyBatch) {
  const auto expected = alone(all_kinds());
  std::mt19937 generator(3);
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Body> bodies = all_kinds();
    for (int step = 0; step < kSteps; ++step) {
      for (Body& body : bodies) body.change(step);
      std::shuffle(order.begin(), order.end(), generator);
      std::size_t next = 0;
      while (next < order.size()) {
        const std::size_t count = std::min<std::size_t>(1 + generator() % kLanes, order.size() - next);
        const auto begin = order.begin() + static_cast<std::ptrdiff_t>(next);
        step_together(bodies, {begin, begin + static_cast<std::ptrdiff_t>(count)}, generator() % kLanes,
                      step);
        next += count;
      }
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        ASSERT_TRUE(same_bits(bodies[i].state, expected[i][static_cast<std::size_t>(step)]))
            << bodies[i].name << ", step " << step;
      }
    }
  }
}

// The memory is a shortcut: results without it agree to rounding, but not bit for bit.
TEST(ExactBodies, AreTheSameToRoundingWithoutTheirMemory) {
  const auto remembered = alone(all_kinds());
  std::vector<Body> bodies = all_kinds();
  int different = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies[i];
    const double speed = body.state.omega_W.norm();
    if (speed > 1e3 || body.name.rfind("about the middle", 0) == 0) continue;
    for (int step = 0; step < kSteps; ++step) {
      body.change(step);
      exact().step(body.input(step), body.state);
    }
    const RotationState& end = remembered[i].back();
    // measured 2e-15 (1 + speed)
    EXPECT_LE(testing::angle_between(body.state.q_WB, end.q_WB), 1e-14 * (1.0 + speed)) << body.name;
    different += same_bits(body.state, end) ? 0 : 1;
  }
  EXPECT_GT(different, 20);
}

}  // namespace
}  // namespace polhode
