// Code for each instruction set gives the same bits. The formulas contain sums of products, which fused
// multiply-add, if allowed, would round differently.
#include "simd/instruction_sets.h"

#include <gtest/gtest.h>

#include <vector>

#include "math/polar.h"
#include "math/rotation.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

template <class Real>
struct Case {
  formulas::Vector<Real> inertia_B;
  formulas::Vector<Real> omega_W;
  formulas::UnitQuaternion<Real> q_WB;
};

template <class Real>
struct Outcome {
  formulas::Vector<Real> change_W;
  formulas::UnitQuaternion<Real> turned;
  formulas::Vector<Real> logarithm;
  formulas::UnitQuaternion<Real> nearest;
};

template <class Real>
void compute(const Case<Real>& body, Outcome<Real>& outcome) {
  formulas::Matrix<Real> R_WB = body.q_WB.toRotationMatrix();
  outcome.change_W =
      R_WB * formulas::implicit_gyroscopic_change_B<Real>(body.inertia_B, body.omega_W, Real(0.01));
  outcome.turned = formulas::turn_by_euler<Real>(body.q_WB, body.omega_W, Real(0.01));
  outcome.turned = formulas::turn_exponentially<Real>(outcome.turned, body.omega_W, Real(0.1));
  outcome.logarithm = formulas::logarithm<Real>(outcome.turned);
  for (int i = 0; i < 3; ++i) R_WB.col(i) += 0.05 * body.omega_W.cross(R_WB.col(i));
  outcome.nearest = formulas::nearest_rotation<Real>(R_WB, body.q_WB);
}

using Compute = void (*)(const Case<Wide>&, Outcome<Wide>&);

POLHODE_FOR_EACH_INSTRUCTION_SET
void compute_by_the_best(const Case<Wide>& body, Outcome<Wide>& outcome) {
  compute(body, outcome);
}

std::vector<Compute> every_instruction_set() {
  std::vector<Compute> result = {compute<Wide>, compute_by_the_best};
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    result.push_back([](const Case<Wide>& body, Outcome<Wide>& outcome)
                         __attribute__((flatten, target("avx2"))) { compute(body, outcome); });
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    result.push_back([](const Case<Wide>& body, Outcome<Wide>& outcome)
                         __attribute__((flatten, target("avx2,fma"))) { compute(body, outcome); });
  }
  if (__builtin_cpu_supports("avx512f")) {
    result.push_back([](const Case<Wide>& body, Outcome<Wide>& outcome)
                         __attribute__((flatten, target("avx512f"))) { compute(body, outcome); });
  }
#endif
  return result;
}

using Plain = BasicWide<PlainRegisters>;

template <class Values>
bool same_in_all_lanes(const Values& a, const Eigen::Matrix<Plain, Values::RowsAtCompileTime, 1>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!same_bits(a[i][lane], b[i][lane])) return false;
    }
  }
  return true;
}

TEST(InstructionSets, GiveTheBitsOfPlainCode) {
  RandomBody random(12);
  for (int trial = 0; trial < 200; ++trial) {
    Case<Wide> body;
    Case<Plain> plain_body;
    const auto set = [](auto& values, auto& plain_values, std::size_t lane, const auto& doubles) {
      for (Eigen::Index i = 0; i < doubles.size(); ++i) {
        values[i].set(lane, doubles[i]);
        plain_values[i].set(lane, doubles[i]);
      }
    };
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      set(body.inertia_B, plain_body.inertia_B, lane, random.inertia_B());
      set(body.omega_W, plain_body.omega_W, lane, random.omega_W());
      set(body.q_WB.coeffs(), plain_body.q_WB.coeffs(), lane, random.q_WB().coeffs());
    }
    Outcome<Plain> expected;
    compute(plain_body, expected);
    for (const Compute compute_once : every_instruction_set()) {
      Outcome<Wide> outcome;
      compute_once(body, outcome);
      ASSERT_TRUE(same_in_all_lanes(outcome.change_W, expected.change_W));
      ASSERT_TRUE(same_in_all_lanes(outcome.turned.coeffs(), expected.turned.coeffs()));
      ASSERT_TRUE(same_in_all_lanes(outcome.logarithm, expected.logarithm));
      ASSERT_TRUE(same_in_all_lanes(outcome.nearest.coeffs(), expected.nearest.coeffs()));
    }
  }
}

}  // namespace
}  // namespace polhode
