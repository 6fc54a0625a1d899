#include <gtest/gtest.h>
#include <polhode/version.h>

#include <cstdio>

namespace polhode {
namespace {

TEST(Version, IsTheSameInHeadersLibraryAndComparableNumber) {
  EXPECT_STREQ(version(), POLHODE_VERSION_STRING);
  int major = -1;
  int minor = -1;
  int patch = -1;
  ASSERT_EQ(std::sscanf(version(), "%d.%d.%d", &major, &minor, &patch), 3);
  EXPECT_EQ(major, POLHODE_VERSION_MAJOR);
  EXPECT_EQ(minor, POLHODE_VERSION_MINOR);
  EXPECT_EQ(patch, POLHODE_VERSION_PATCH);
  EXPECT_EQ(10000 * major + 100 * minor + patch, POLHODE_VERSION);
}

}  // namespace
}  // namespace polhode
