// Torque laws and motors: what steps converge to, and with which order.
#include "scheme_base/driven_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "polhode/torque_laws.h"
#include "support/driven_reference.h"
#include "support/free_motion_reference.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::DrivenStart;
using testing::integrate_driven;
using testing::same_bits;
using testing::state_from;

const Vector3 kInertia_B(1.0, 2.0, 3.0);
const DrivenStart kPlace = {0.3, Vector3(2.0, 0.5, -1.0), Vector3(0.5, 1.0, 0.2)};

RotationState start_state() {
  return state_from(kInertia_B, Quaternion(0.5, 0.1, -0.7, 0.5).normalized(), {3.0, 2.0, 4.0});
}

RotationState run(const RotationScheme& scheme, Drive drive, RotationState state, double duration,
                  int steps) {
  const double dt = duration / steps;
  state.rotor_momentum_B = drive.rotor_momentum_B;
  for (int i = 0; i < steps; ++i) {
    const StepStart start = {kPlace.time_s + i * dt, kPlace.position_W + i * dt * kPlace.velocity_W,
                             kPlace.velocity_W};
    const DrivenStep step = take_driven_step(scheme, {kInertia_B, Vector3::Zero(), dt}, start, drive, state);
    EXPECT_FALSE(step.law_failed);
    drive.last_torque = step.last_torque;
    state = step.end;
  }
  return state;
}

struct NamedLaw {
  std::string name;
  TorqueLaw law;
};

Vector3 pull(const TorqueLawInput& motion) {
  return 20.0 * (motion.q_WB * Vector3::UnitX()).cross(Vector3(0.6, 0.0, 0.8));
}

/// Returns laws that depend on the pose, the angular velocity, the time, the position, and all of these.
std::vector<NamedLaw> laws() {
  const auto in_time = [](const TorqueLawInput& motion) {
    return WorldTorque{Vector3(std::sin(9.0 * motion.time_s), 3.0, std::cos(5.0 * motion.time_s)) * 4.0};
  };
  const auto of_all = [](const TorqueLawInput& motion) {
    return Torque(WorldTorque{pull(motion) + motion.position_W.cross(motion.velocity_W) * motion.time_s}) +
           Torque(BodyTorque{Vector3(2.0, 1.0, 0.5).cross(motion.omega_B())});
  };
  return {{"pose", [](const TorqueLawInput& motion) { return WorldTorque{pull(motion)}; }},
          {"rate", rate_damping(Vector3(0.5, 2.0, 1.0))},
          {"time", in_time},
          {"place", gravity_gradient(40.0)},
          {"all", of_all}};
}

class EveryLaw : public ::testing::TestWithParam<std::tuple<SchemePointer, NamedLaw>> {
 protected:
  const RotationScheme& scheme() const { return *std::get<0>(GetParam()); }
  const TorqueLaw& law() const { return std::get<1>(GetParam()).law; }

  double slope(TorqueLawOrder order, int steps) const {
    const double duration = 0.5;
    const RotationState exact = integrate_driven(kInertia_B, start_state(), kPlace, law(), duration, 20000);
    const auto error = [&](int count) {
      Drive drive;
      drive.law = law();
      drive.order = order;
      const RotationState end = run(scheme(), drive, start_state(), duration, count);
      return angle_between(end.q_WB, exact.q_WB) + (end.omega_W - exact.omega_W).norm();
    };
    return std::log2(error(steps) / error(2 * steps));
  }
};

TEST_P(EveryLaw, ConvergesWithItsOrderOrTheSchemes) {
  const int of_scheme = scheme().description().order.value_or(4);
  for (const TorqueLawOrder order : {TorqueLawOrder::two, TorqueLawOrder::four}) {
    const int expected = std::min(of_scheme, of_scheme == 1 ? 1 : static_cast<int>(order));
    SCOPED_TRACE("order " + std::to_string(expected));
    // Small enough for the leading term of the error to dominate, large enough for rounding not to matter.
    const int steps = expected == 1 ? 4000 : expected == 2 ? 800 : 60;
    EXPECT_NEAR(slope(order, steps), expected, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryLaw,
                         ::testing::Combine(::testing::ValuesIn(built_in_schemes()),
                                            ::testing::ValuesIn(laws())),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)->description().name) + "_" +
                                  std::get<1>(test.param).name;
                         });

TEST(DrivenStep, ReferenceHasConverged) {
  const TorqueLaw law = laws().back().law;
  const RotationState fine = integrate_driven(kInertia_B, start_state(), kPlace, law, 0.5, 20000);
  const RotationState coarse = integrate_driven(kInertia_B, start_state(), kPlace, law, 0.5, 10000);
  EXPECT_LE(angle_between(fine.q_WB, coarse.q_WB) + (fine.omega_W - coarse.omega_W).norm(), 1e-11);
}

TEST(DrivenStep, OfOrderTwoAsksTheLawOnceAStep) {
  int asked = 0;
  Drive drive;
  drive.law = [&asked](const TorqueLawInput& motion) {
    ++asked;
    return BodyTorque{-motion.omega_B()};
  };
  run(*find_scheme("exact"), drive, start_state(), 1.0, 10);
  EXPECT_EQ(asked, 11);  // twice in the first step
}

TEST(DrivenStep, OfOrderFourAsksALawOfThePoseTwelveTimes) {
  int asked = 0;
  Drive drive;
  drive.order = TorqueLawOrder::four;
  drive.law = [&asked](const TorqueLawInput& motion) {
    ++asked;
    return WorldTorque{pull(motion)};
  };
  run(*find_scheme("exact"), drive, start_state(), 1.0, 10);
  EXPECT_EQ(asked, 120);
}

TEST(DrivenStep, OfALawThatFailsIsTheStepWithoutIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<TorqueLaw> failing = {
      [](const TorqueLawInput&) -> Torque { throw std::runtime_error("no torque today"); },
      [nan](const TorqueLawInput&) { return WorldTorque{Vector3(0.0, nan, 0.0)}; },
      [nan](const TorqueLawInput&) { return BodyTorque{Vector3(nan, 0.0, 0.0)}; },
      [](const TorqueLawInput&) {
        return BodyTorque{Vector3(0.0, 0.0, std::numeric_limits<double>::infinity())};
      },
      [nan](const TorqueLawInput&) { return RotorTorque{Vector3(0.0, 0.0, nan)}; }};
  const StepInput input = {kInertia_B, Vector3(0.1, 0.2, -0.3), 0.01};
  for (const SchemePointer& scheme : built_in_schemes()) {
    RotationState expected = start_state();
    scheme->step(input, expected);
    for (const TorqueLaw& law : failing) {
      for (const TorqueLawOrder order : {TorqueLawOrder::two, TorqueLawOrder::four}) {
        Drive drive;
        drive.law = law;
        drive.order = order;
        const DrivenStep step = take_driven_step(*scheme, input, {}, drive, start_state());
        EXPECT_TRUE(step.law_failed);
        EXPECT_FALSE(step.last_torque.has_value());
        EXPECT_TRUE(same_bits(step.end, expected)) << scheme->description().name;
      }
    }
  }
}

TEST(DrivenStep, OfASchemeWithoutRotorsFailsALawThatTurnsThem) {
  Drive drive;
  drive.law = [](const TorqueLawInput&) { return RotorTorque{Vector3(0.0, 0.0, 0.1)}; };
  const StepInput input = {kInertia_B, Vector3::Zero(), 0.01};
  for (const SchemePointer& scheme : built_in_schemes()) {
    const DrivenStep step = take_driven_step(*scheme, input, {}, drive, start_state());
    EXPECT_EQ(step.law_failed, !scheme->description().takes_rotors) << scheme->description().name;
  }
}

// A pendulum of two magnets. A law of the pose acts as the kick of a symplectic scheme: the energy oscillates
// without drift.
TEST(DrivenStep, KeepsTheEnergyOfAConservativeLawForAMillionSteps) {
  const Vector3 dipole_B = Vector3::UnitX();
  const Vector3 field_W(0.6, 0.0, 0.8);
  Drive drive;
  drive.law = magnetic_dipole(20.0 * dipole_B, field_W);
  const double dt = 0.01;
  RotationState state = start_state();
  const auto energy = [&](const RotationState& now) {
    return now.energy() - 20.0 * (now.q_WB * dipole_B).dot(field_W);
  };
  const double start_energy = energy(state);
  const auto worst_of = [&](int steps) {
    double worst = 0.0;
    for (int i = 0; i < steps; ++i) {
      const DrivenStep step =
          take_driven_step(*find_scheme("exact"), {kInertia_B, Vector3::Zero(), dt}, {}, drive, state);
      state = step.end;
      drive.last_torque = step.last_torque;
      worst = std::max(worst, std::abs(energy(state) / start_energy - 1.0));
    }
    return worst;
  };
  const double first = worst_of(10'000);
  worst_of(980'000);
  const double last = worst_of(10'000);
  RecordProperty("worst_of_the_first_steps", std::to_string(first));
  EXPECT_LE(first, 1e-3);
  EXPECT_LE(last, 1.2 * first);
}

// Internal torques cannot change the total momentum.
TEST(DrivenStep, OfMotorsKeepsTheWholeMomentum) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (!scheme->description().takes_rotors || scheme->description().angular_momentum != Conservation::exact)
      continue;
    Drive drive;
    drive.rotor_torque_B = Vector3(0.3, -0.2, 0.1);
    const RotationState end = run(*scheme, drive, start_state(), 2.0, 200);
    EXPECT_EQ(end.L_W, start_state().L_W) << scheme->description().name;
    EXPECT_LE((end.rotor_momentum_B - 2.0 * drive.rotor_torque_B).norm(), 1e-14);
    const Vector3 sum_W =
        end.R_WB * (kInertia_B.cwiseProduct(end.R_WB.transpose() * end.omega_W) + end.rotor_momentum_B);
    EXPECT_LE((sum_W - end.L_W).norm(), 1e-13 * end.L_W.norm());
  }
}

TEST(DrivenStep, OfMotorsConvergesWithOrderTwo) {
  const Vector3 torque_B(2.0, -1.0, 3.0);
  const TorqueLaw same_law = [torque_B](const TorqueLawInput&) { return RotorTorque{torque_B}; };
  const RotationState exact = integrate_driven(kInertia_B, start_state(), kPlace, same_law, 0.5, 20000);
  for (const SchemePointer& scheme : built_in_schemes()) {
    const SchemeDescription description = scheme->description();
    if (!description.takes_rotors) continue;
    const auto error = [&](int steps) {
      Drive drive;
      drive.rotor_torque_B = torque_B;
      const RotationState end = run(*scheme, drive, start_state(), 0.5, steps);
      return angle_between(end.q_WB, exact.q_WB) + (end.omega_W - exact.omega_W).norm();
    };
    EXPECT_NEAR(std::log2(error(500) / error(1000)), std::min(2, description.order.value_or(2)), 0.05)
        << description.name;
  }
}

// Internal damping dissipates energy until the body spins about its axis of largest moment.
TEST(DrivenStep, OfInternalDampingKeepsMomentumAndLosesEnergy) {
  Drive drive;
  drive.law = internal_damping(0.2, 0.4);
  RotationState state = state_from(kInertia_B, Quaternion::Identity(), {6.0, 0.1, 0.1});
  const Vector3 L_W = state.L_W;
  double energy = 1e300;
  for (int second = 0; second < 100; ++second) {
    state = run(*find_scheme("exact"), drive, state, 1.0, 60);
    drive.rotor_momentum_B = state.rotor_momentum_B;
    const Vector3 h = state.rotor_momentum_B;
    const double now = state.energy() + 0.5 * h.squaredNorm() / 0.2;
    EXPECT_LE(now, energy * (1.0 + 1e-12));
    energy = now;
    EXPECT_EQ(state.L_W, L_W);
  }
  EXPECT_GE((state.R_WB.transpose() * L_W).normalized().cwiseAbs().z(), 0.999999);
  EXPECT_NEAR(energy, 0.5 * L_W.squaredNorm() / (3.0 + 0.2), 1e-6);
}

}  // namespace
}  // namespace polhode
