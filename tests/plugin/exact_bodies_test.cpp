// `exact` steps bodies eight at a time: what becomes of one is its own affair.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::state_from;

constexpr double kDt = 1.0 / 60.0;
constexpr int kSteps = 12;

/// A body and what is done to it.
struct Body {
  std::string name;
  Vector3 inertia_B;
  RotationState state;
  double dt = kDt;
  double stopped_part = 0.0;  // of dt, by continuous collision
  Vector3 kick = Vector3::Zero();
  int kicked_every = 1;  // steps
  Vector3 torque_W = Vector3::Zero();
  bool torque_turns_with_body = false;
  double swelling = 0.0;   // of the inertia, from the middle of the run on
  double faster_dt = 0.0;  // every third step, in place of dt
  int changed_every = 0;   // steps: somebody else changes its state, tells nobody
  SchemeMemory memory = {};

  /// What happens between two steps.
  void change(int step) {
    if (changed_every == 0 || step % changed_every != 0) return;
    state = state_from(inertia_B, state.q_WB, state.omega_W + Vector3(0.1, 0.0, -0.2));
  }

  StepInput input(int step) const {
    const double h = faster_dt != 0.0 && step % 3 == 2 ? faster_dt : dt;
    StepInput input{inertia_B, Vector3::Zero(), h, h * (1.0 - stopped_part)};
    if (2 * step >= kSteps) input.inertia_B *= 1.0 + swelling;
    if (step % kicked_every == 0) input.delta_omega_W = kick;
    input.torque_W = torque_W;
    input.torque_turns_with_body = torque_turns_with_body;
    return input;
  }
};

/// Bodies of every kind, so many of each that blocks of eight fill up in every way.
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
  // Slow enough for a step of 1/60 s to be short, whatever the random moments are.
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
    add_slow("torque").torque_W = Vector3(1, -2, 0.5 * i);
    add_slow("torque at a short dt").torque_W = Vector3(1, -2, 0.5 * i);
    bodies.back().dt = 1e-3;
    add_slow("torque of the body").torque_W = Vector3(1, 2, 0.5 * i);
    bodies.back().torque_turns_with_body = true;
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
    add_slow("stopped early").stopped_part = 0.3;
    add_slow("stopped at once").stopped_part = 1.0;
    add_slow("inertia that changes").swelling = 0.5;
    add("beyond double precision", Vector3(1, 2, 3), Vector3(1e200, 1e200, i));
  }
  return bodies;
}

bool same_bits(const RotationState& a, const RotationState& b) {
  const auto same = [](const auto& x, const auto& y) {
    return std::memcmp(x.data(), y.data(), sizeof(double) * static_cast<std::size_t>(x.size())) == 0;
  };
  return same(a.q_WB.coeffs(), b.q_WB.coeffs()) && same(a.R_WB, b.R_WB) && same(a.omega_W, b.omega_W) &&
         same(a.L_W, b.L_W);
}

/// The states after each step, each body by itself.
std::vector<std::vector<RotationState>> alone(std::vector<Body> bodies) {
  const SchemePointer scheme = find_scheme("exact");
  std::vector<std::vector<RotationState>> states(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (int step = 0; step < kSteps; ++step) {
      bodies[i].change(step);
      scheme->step_with_memory(bodies[i].input(step), bodies[i].state, bodies[i].memory);
      states[i].push_back(bodies[i].state);
    }
  }
  return states;
}

/// Steps bodies[order[0]], bodies[order[1]], ... together, `count` of them in each call.
void step_together(std::vector<Body>& bodies, const std::vector<std::size_t>& order, std::size_t count,
                   int step) {
  std::vector<StepInput> inputs;
  for (Body& body : bodies) {
    body.change(step);
    inputs.push_back(body.input(step));
  }
  std::vector<BodyStep> steps;
  for (const std::size_t i : order) steps.push_back({&inputs[i], &bodies[i].state, &bodies[i].memory});
  for (std::size_t first = 0; first < steps.size(); first += count) {
    find_scheme("exact")->step_bodies(&steps[first], std::min(count, steps.size() - first));
  }
}

TEST(ExactBodies, MoveToTheLastBitAsEachAloneWhateverTheirNumberAndOrder) {
  const auto expected = alone(all_kinds());
  std::mt19937 generator(3);
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::size_t> counts(20);
  std::iota(counts.begin(), counts.end(), std::size_t{1});
  counts.push_back(order.size());
  for (const std::size_t count : counts) {
    std::vector<Body> bodies = all_kinds();
    for (int step = 0; step < kSteps; ++step) {
      step_together(bodies, order, count, step);
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        ASSERT_TRUE(same_bits(bodies[i].state, expected[i][static_cast<std::size_t>(step)]))
            << bodies[i].name << ", step " << step << ", " << count << " together";
      }
      std::shuffle(order.begin(), order.end(), generator);
    }
  }
}

TEST(ExactBodies, LeaveTheOthersAlone) {
  std::vector<Body> bodies = all_kinds();
  const std::vector<Body> before = bodies;
  step_together(bodies, {0, 20, 40}, 2, 1);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool is_stepped = i == 0 || i == 20 || i == 40;
    EXPECT_EQ(same_bits(bodies[i].state, before[i].state), !is_stepped) << bodies[i].name;
  }
  find_scheme("exact")->step_bodies(nullptr, 0);
}

// What a step keeps is found again: with the memory emptied before each step the last bits differ.
TEST(ExactBodies, UseWhatTheyKeep) {
  std::vector<Body> keeping = all_kinds();
  std::vector<Body> forgetting = all_kinds();
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < keeping.size(); ++i) {
    if (keeping[i].name.rfind("every order", 0) == 0) order.push_back(i);
  }
  for (int step = 0; step < kSteps; ++step) {
    step_together(keeping, order, order.size(), step);
    for (Body& body : forgetting) body.memory = SchemeMemory();
    step_together(forgetting, order, order.size(), step);
  }
  for (const std::size_t i : order) {
    EXPECT_FALSE(same_bits(keeping[i].state, forgetting[i].state));
    EXPECT_LE(testing::angle_between(keeping[i].state.q_WB, forgetting[i].state.q_WB), 1e-14);
  }
}

}  // namespace
}  // namespace polhode
