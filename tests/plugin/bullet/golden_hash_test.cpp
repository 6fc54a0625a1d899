// A scene with all features ends in the same bits in every build of the library, on every machine. Compares
// this build with the hashes in the repository; `scripts/determinism` compares many builds.
#include <gtest/gtest.h>

#include "determinism/golden_hashes.h"

namespace polhode::testing {
namespace {

class GoldenHash : public ::testing::Test {
 protected:
  // Bullet's version number does not show how Bullet was compiled or which C library it calls, so compare its
  // own results.
  void SetUp() override {
    static const bool is_the_bullet = hash_in_plain_bullet<btDiscreteDynamicsWorld>() == kGoldenOfPlainBullet;
    if (!is_the_bullet) GTEST_SKIP() << "plain Bullet gives other bits than the 3.24 of Debian 12 on x86-64";
  }
};

TEST_F(GoldenHash, IsReachedByARotationWorld) {
  EXPECT_EQ(hash_in_rotation_world<btDiscreteDynamicsWorld>(), kGolden.discrete);
}

TEST_F(GoldenHash, IsReachedByARotationPlugin) {
  EXPECT_EQ(hash_under_rotation_plugin<btDiscreteDynamicsWorld>(), kGolden.discrete);
}

TEST_F(GoldenHash, IsReachedByARotationWorldThatIsMultithreaded) {
  EXPECT_EQ(hash_in_rotation_world<btDiscreteDynamicsWorldMt>(), kGolden.discrete_mt);
}

TEST_F(GoldenHash, IsReachedByARotationPluginInAMultithreadedWorld) {
  EXPECT_EQ(hash_under_rotation_plugin<btDiscreteDynamicsWorldMt>(), kGolden.discrete_mt);
}

}  // namespace
}  // namespace polhode::testing
