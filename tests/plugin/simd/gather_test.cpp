// Gathers rows of numbers, one row per body, into wide numbers and scatters them back.
#include "simd/gather.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace polhode {
namespace {

template <class Number>
class WideRowsOf : public ::testing::Test {
 protected:
  // Two rows of four per lane, in shuffled order, followed by a number that must keep its value.
  static constexpr std::size_t kStride = 9;

  WideRowsOf() {
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = static_cast<Number>(i + 1);
  }
  Number* row_of(std::size_t lane) { return &numbers_[(lane * 5 % kLanes) * kStride]; }

  std::array<Number, kStride * kLanes> numbers_;
};

using Numbers = ::testing::Types<float, double>;

struct NumberName {
  template <class Number>
  static std::string GetName(int /*index*/) {
    return sizeof(Number) == sizeof(double) ? "Double" : "Float";
  }
};
TYPED_TEST_SUITE(WideRowsOf, Numbers, NumberName);

template <class Number>
WideRowsOfFour<Number> negated(const WideRowsOfFour<Number>& rows) {
  return {-rows.x, -rows.y, -rows.z, -rows.w};
}

TYPED_TEST(WideRowsOf, AreLoaded) {
  const auto row_of = [this](std::size_t lane) { return this->row_of(lane); };
  const auto four = gather_rows_of_four<TypeParam>(row_of);
  const auto three = gather_rows<TypeParam>(row_of);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const TypeParam* row = this->row_of(lane);
    EXPECT_EQ(four.x[lane], row[0]);
    EXPECT_EQ(four.y[lane], row[1]);
    EXPECT_EQ(four.z[lane], row[2]);
    EXPECT_EQ(four.w[lane], row[3]);
    EXPECT_EQ(three.x[lane], row[0]);
    EXPECT_EQ(three.y[lane], row[1]);
    EXPECT_EQ(three.z[lane], row[2]);
  }
}

// `expected(i, number)` is the expected new value of number i of a lane's nine.
template <class Number, class Expected>
void expect_numbers(const std::array<Number, 9 * kLanes>& found, const std::array<Number, 9 * kLanes>& before,
                    Expected expected) {
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected(i % 9, before[i])) << i;
}

TYPED_TEST(WideRowsOf, OfFourAreStored) {
  const auto row_of = [this](std::size_t lane) { return this->row_of(lane); };
  const auto before = this->numbers_;
  scatter_rows_of_four(negated(gather_rows_of_four<TypeParam>(row_of)), row_of);
  expect_numbers(this->numbers_, before,
                 [](std::size_t i, TypeParam number) { return i < 4 ? -number : number; });
}

TYPED_TEST(WideRowsOf, OfThreeAreStoredWithNothingBehindThem) {
  const auto row_of = [this](std::size_t lane) { return this->row_of(lane); };
  const auto before = this->numbers_;
  const auto rows = negated(gather_rows_of_four<TypeParam>(row_of));
  scatter_rows_of_three(WideRows<TypeParam>{rows.x, rows.y, rows.z}, row_of);
  expect_numbers(this->numbers_, before,
                 [](std::size_t i, TypeParam number) { return i < 3 ? -number : number; });
}

TYPED_TEST(WideRowsOf, AreStoredWithAZero) {
  const auto row_of = [this](std::size_t lane) { return this->row_of(lane); };
  const auto before = this->numbers_;
  scatter_rows(gather_rows<TypeParam>(row_of), row_of);
  expect_numbers(this->numbers_, before,
                 [](std::size_t i, TypeParam number) { return i == 3 ? TypeParam(0) : number; });
}

TYPED_TEST(WideRowsOf, OfTwoThatFollowOneAnotherAreStoredTogether) {
  const auto row_of = [this](std::size_t lane) { return this->row_of(lane); };
  const auto before = this->numbers_;
  const auto first = negated(gather_rows_of_four<TypeParam>(row_of));
  const auto second =
      negated(gather_rows_of_four<TypeParam>([this](std::size_t lane) { return this->row_of(lane) + 4; }));
  scatter_two_rows(WideRows<TypeParam>{first.x, first.y, first.z},
                   WideRows<TypeParam>{second.x, second.y, second.z}, row_of);
  expect_numbers(this->numbers_, before, [](std::size_t i, TypeParam number) {
    if (i == 3 || i == 7) return TypeParam(0);
    return i < 8 ? -number : number;
  });
}

}  // namespace
}  // namespace polhode
