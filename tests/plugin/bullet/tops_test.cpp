// A heavy top on a point joint precesses steadily and does not fall.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/constrained_scene.h"

namespace polhode::testing {
namespace {

struct TopRun {
  double precession_error;  // relative to the mean rate
  Range tilt;               // rad
};

template <class AnyScene>
TopRun run_top(AnyScene& scene, double spin, int steps_per_second) {
  const Top top = add_top(scene, spin);
  TopRun run{};
  double azimuth = 0;
  double last = top.azimuth();
  for (int i = 0; i < 10 * steps_per_second; ++i) {
    scene.step(btScalar(1.0 / steps_per_second));
    azimuth += std::remainder(top.azimuth() - last, 2 * M_PI);
    last = top.azimuth();
    run.tilt.add(top.tilt());
  }
  run.precession_error = azimuth / 10 / top.precession - 1;
  return run;
}

template <class Way>
class Tops : public ::testing::Test {
 protected:
  Way scene_;
};
TYPED_TEST_SUITE(Tops, BothWays, WayName);

TYPED_TEST(Tops, PrecessSteadilyAtAShortStep) {
  const TopRun run = run_top(this->scene_, 20, 240);
  EXPECT_LT(std::abs(run.precession_error), 2e-4);  // measured 1.1e-4
  EXPECT_GT(run.tilt.lowest, 0.495);                // measured 0.4961
  EXPECT_LT(run.tilt.highest, 0.505);               // measured 0.5043
}

TYPED_TEST(Tops, PrecessSteadilyAtALongStep) {
  const TopRun run = run_top(this->scene_, 20, 60);
  EXPECT_LT(std::abs(run.precession_error), 1e-3);  // measured 5.7e-4
  EXPECT_GT(run.tilt.lowest, 0.491);                // measured 0.4936
  EXPECT_LT(run.tilt.highest, 0.522);               // measured 0.5190
}

TYPED_TEST(Tops, StandThoughTheyTurnTwoAndAHalfRadiansAStep) {
  const TopRun run = run_top(this->scene_, 150, 60);
  EXPECT_LT(std::abs(run.precession_error), 8e-4);  // measured 4.3e-4
  EXPECT_GT(run.tilt.lowest, 0.494);                // measured 0.4952
  EXPECT_LT(run.tilt.highest, 0.5005);              // measured 0.4991
}

TEST(TopsOfPlainBullet, Fall) {
  Scene<> scene;
  const TopRun run = run_top(scene, 20, 60);
  EXPECT_LT(run.precession_error, -0.1);  // measured -0.17
  EXPECT_GT(run.tilt.highest, 2);         // measured 2.98
}

}  // namespace
}  // namespace polhode::testing
