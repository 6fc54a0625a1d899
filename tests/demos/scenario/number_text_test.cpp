#include "scenario/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "demos/foreign_locale.h"
#include "scenario/range.h"

namespace polhode::demos {
namespace {

TEST(NumberText, ReadsBackAsTheSameNumber) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    EXPECT_EQ(parse_number(number_text(value)), value);
    EXPECT_EQ(parse_number(full_number_text(value)), value);
  }
}

TEST(NumberText, HasSeventeenDigitsWhereItIsFull) {
  EXPECT_EQ(full_number_text(0.1), "0.10000000000000001");
  EXPECT_EQ(full_number_text(1.0 / 60.0), "0.016666666666666666");
}

TEST(NumberText, IgnoresTheGlobalLocale) {
  const ForeignLocale foreign;
  std::ostringstream stream;
  stream << 1234.5;
  ASSERT_EQ(stream.str(), "1.234,5") << "the foreign locale is not in force";
  EXPECT_EQ(number_text(1234.5), "1234.5");
  EXPECT_EQ(full_number_text(1234.5), "1234.5");
  EXPECT_EQ(number_text(std::int64_t{1234567}), "1234567");
  EXPECT_EQ(range_text({0.5, 12345.5}), "a finite number between 0.5 and 12345.5");
  EXPECT_EQ(parse_number("1234.5"), 1234.5);
}

TEST(NumberText, TakesNothingButAFiniteNumber) {
  for (const char* text : {"", " ", "1 ", " 1", "1x", "1,5", "nan", "inf", "-inf", "1e999", "0x10", "+1"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace polhode::demos
