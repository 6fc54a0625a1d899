// Operations on Wide give in each lane the bits of the same operation on double, for every kind of registers.
#include "simd/wide.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::same_bits;

// Zeros, subnormals, the ends of the range, infinities, NaN, and numbers of all magnitudes.
std::vector<double> samples() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> result = {
      0.0,  0.5,  1.0,           3.0,         Limits::denorm_min(), Limits::min(),
      1e-9, 1e99, Limits::max(), 1.0 + 1e-15, Limits::infinity(),   Limits::quiet_NaN()};
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> fraction(1.0, 2.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  while (result.size() < 40) result.push_back(std::ldexp(fraction(generator), exponent(generator)));
  for (std::size_t i = result.size(); i > 0; --i) result.push_back(-result[i - 1]);
  return result;
}

template <class Registers>
class WideOf : public ::testing::Test {
 protected:
  using Some = BasicWide<Registers>;

  // A different sample in each lane; every pair of samples occurs in some lane of some pair of Wide.
  static Some some_from(std::size_t first, std::size_t stride) {
    static const std::vector<double> values = samples();
    Some result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      result.set(lane, values[(first + stride * lane) % values.size()]);
    }
    return result;
  }

  template <class Check>
  static void for_pairs(Check check) {
    const std::size_t count = samples().size();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) check(some_from(i, 1), some_from(j, 3));
    }
  }

  // Compares `of_lanes(a, b)[lane]` with `of_doubles(a[lane], b[lane])`.
  template <class OfLanes, class OfDoubles>
  static void expect_same(OfLanes of_lanes, OfDoubles of_doubles) {
    for_pairs([&](const Some& a, const Some& b) {
      const auto result = of_lanes(a, b);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        ASSERT_TRUE(same_bits(result[lane], of_doubles(a[lane], b[lane]))) << a[lane] << " " << b[lane];
      }
    });
  }

  // The same formula for both.
  template <class Formula>
  static void expect_same(Formula formula) {
    expect_same(formula, formula);
  }
};

#if defined(__GNUC__)
using Kinds = ::testing::Types<PlainRegisters, VectorRegisters>;
#else
using Kinds = ::testing::Types<PlainRegisters>;
#endif

struct KindName {
  template <class Registers>
  static std::string GetName(int /*index*/) {
    return std::is_same_v<Registers, PlainRegisters> ? "Plain" : "Vector";
  }
};
TYPED_TEST_SUITE(WideOf, Kinds, KindName);

TYPED_TEST(WideOf, ComputeAsDoubles) {
  this->expect_same([](const auto& a, const auto& b) { return a + b; });
  this->expect_same([](const auto& a, const auto& b) { return a - b; });
  this->expect_same([](const auto& a, const auto& b) { return a * b; });
  this->expect_same([](const auto& a, const auto& b) { return a / b; });
  this->expect_same([](const auto& a, const auto&) { return -a; });
  this->expect_same([](const auto& a, const auto& b) { return 2.0 * a - b / 3.0 + 1.0; });
  this->expect_same([](auto a, const auto& b) { return a += b; });
  this->expect_same([](auto a, const auto& b) { return a -= b; });
  this->expect_same([](auto a, const auto& b) { return a *= b; });
  this->expect_same([](auto a, const auto& b) { return a /= b; });
}

TYPED_TEST(WideOf, HaveTheFunctionsOfDoubles) {
  using std::abs, std::max, std::min, std::sqrt;
  this->expect_same([](const auto& a, const auto&) { return sqrt(a); });
  this->expect_same([](const auto& a, const auto&) { return abs(a); });
  this->expect_same([](const auto& a, const auto& b) { return std::decay_t<decltype(a)>(min(a, b)); });
  this->expect_same([](const auto& a, const auto& b) { return std::decay_t<decltype(a)>(max(a, b)); });
}

TYPED_TEST(WideOf, CompareAsDoubles) {
  this->expect_same([](const auto& a, const auto& b) { return a < b; });
  this->expect_same([](const auto& a, const auto& b) { return a <= b; });
  this->expect_same([](const auto& a, const auto& b) { return a > b; });
  this->expect_same([](const auto& a, const auto& b) { return a >= b; });
  this->expect_same([](const auto& a, const auto& b) { return a == b; });
  this->expect_same([](const auto& a, const auto& b) { return a != b; });
  this->expect_same([](const auto& a, const auto& b) { return (b > 1.0) & !(a < b); });
  this->expect_same([](const auto& a, const auto& b) { return (a < b) | (b > 1.0); });
}

TYPED_TEST(WideOf, AreSelectedLaneByLane) {
  this->expect_same([](const auto& a, const auto& b) { return select(a < b, a, b * 2.0); });
}

TYPED_TEST(WideOf, KnowWhetherAMaskHoldsInAnyOrAll) {
  this->for_pairs([](const auto& a, const auto& b) {
    std::size_t less = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) less += a[lane] < b[lane] ? 1 : 0;
    ASSERT_EQ(any(a < b), less > 0);
    ASSERT_EQ(all(a < b), less == kLanes);
  });
}

TYPED_TEST(WideOf, HaveMasksFromBits) {
  using Mask = BasicWideMask<TypeParam>;
  for (unsigned bits = 0; bits < 256; ++bits) {
    ASSERT_EQ(Mask::from_bits(bits).bits().to_ulong(), bits);
    ASSERT_EQ((!Mask::from_bits(bits)).bits().to_ulong(), 255 - bits);
    ASSERT_EQ((Mask::from_bits(bits) & Mask::from_bits(0x3c)).bits().to_ulong(), bits & 0x3c);
  }
}

TYPED_TEST(WideOf, TellWhichHaveTheSameBits) {
  this->for_pairs([](const auto& a, const auto& b) {
    BasicWideDifferences<TypeParam> differences;
    differences.add(a, a);
    ASSERT_TRUE(all(differences.are_none()));
    differences.add(a, b);
    differences.add(b, b);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double number_a = a[lane];
      const double number_b = b[lane];
      const bool same = std::memcmp(&number_a, &number_b, sizeof number_a) == 0;
      ASSERT_EQ(differences.are_none()[lane], same);
    }
  });
}

// The same kind of registers, for floats.
template <template <class> class KindOf>
BasicWide<KindOf<float>> of_floats(const KindOf<double>&);

TYPED_TEST(WideOf, AreConvertedAsNumbersAre) {
  using OfFloats = decltype(of_floats(std::declval<TypeParam>()));
  this->for_pairs([](const auto& a, const auto&) {
    const auto rounded = OfFloats::converted(a);
    const auto back = std::decay_t<decltype(a)>::converted(rounded);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      ASSERT_TRUE(same_bits(back[lane], static_cast<double>(static_cast<float>(a[lane])))) << a[lane];
    }
  });
}

// Code for a wider instruction set than the caller's assumes this alignment.
TYPED_TEST(WideOf, AreAlignedForTheWidestInstructionSet) {
  EXPECT_EQ(alignof(BasicWide<TypeParam>), kLanes * sizeof(double));
  EXPECT_EQ(alignof(Eigen::Matrix<BasicWide<TypeParam>, 3, 1>), kLanes * sizeof(double));
}

// Eigen sums doubles in a different order, so the reference for a number is one lane of plain Wide.
TYPED_TEST(WideOf, AreAScalarOfEigens) {
  const auto formula = [](const auto& a, const auto& b) {
    using Real = std::decay_t<decltype(a)>;
    const Eigen::Matrix<Real, 3, 1> u(a, b, Real(1.0)), v(b, Real(-2.0), a);
    const Eigen::Quaternion<Real, Eigen::DontAlign> q(a, b, Real(0.5), Real(2.0));
    const Eigen::Matrix<Real, 3, 1> w = 2.0 * u.cross(v) + q.toRotationMatrix().transpose() * (q * v) / 3.0;
    return Real(w.dot(u) + select(a < b, u, v).squaredNorm());
  };
  using Plain = BasicWide<PlainRegisters>;
  this->expect_same(formula, [formula](double a, double b) { return formula(Plain(a), Plain(b))[0]; });
}

}  // namespace
}  // namespace polhode
