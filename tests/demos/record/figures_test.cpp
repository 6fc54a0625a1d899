#include "record/figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode::demos {
namespace {

Sample sample_with(std::int64_t step, const Vector3& omega_W, const Vector3& L_W, double energy_J) {
  Sample sample;
  sample.step = step;
  sample.t_s = 0.1 * static_cast<double>(step);
  sample.state.omega_W = omega_W;
  sample.state.L_W = L_W;
  sample.energy_J = energy_J;
  return sample;
}

const Vector3 kSpin(1, 0, 0);

TEST(Figures, KeepTheLastAndTheWorstEnergyError) {
  FiguresRecorder recorder(sample_with(0, kSpin, kSpin, 4.0), 0.1);
  recorder.add(sample_with(1, kSpin, kSpin, 7.0));
  recorder.add(sample_with(2, kSpin, kSpin, 3.0));
  EXPECT_EQ(recorder.figures().worst_energy_error, 0.75);
  EXPECT_EQ(recorder.figures().final_energy_error, -0.25);
  EXPECT_EQ(recorder.figures().steps, 2);
}

TEST(Figures, KeepTheWorstLengthAndAngleOfTheMomentum) {
  FiguresRecorder recorder(sample_with(0, kSpin, {2, 0, 0}, 1.0), 0.1);
  recorder.add(sample_with(1, kSpin, {0, 3, 0}, 1.0));
  recorder.add(sample_with(2, kSpin, {1.9, 0, 0}, 1.0));
  EXPECT_EQ(recorder.figures().worst_momentum_error, 0.5);
  EXPECT_EQ(recorder.figures().worst_momentum_angle_rad, std::acos(0.0));
}

TEST(Figures, SeeASmallAngleThatACosineWouldLose) {
  FiguresRecorder recorder(sample_with(0, kSpin, {1, 0, 0}, 1.0), 0.1);
  recorder.add(sample_with(1, kSpin, {1, 1e-12, 0}, 1.0));
  EXPECT_NEAR(*recorder.figures().worst_momentum_angle_rad, 1e-12, 1e-24);  // measured 0
}

TEST(Figures, AreAbsentRelativeToNothing) {
  FiguresRecorder recorder(sample_with(0, {0, 0, 0}, {0, 0, 0}, 0.0), 0.1);
  recorder.add(sample_with(1, kSpin, kSpin, 1.0));
  EXPECT_FALSE(recorder.figures().final_energy_error);
  EXPECT_FALSE(recorder.figures().worst_energy_error);
  EXPECT_FALSE(recorder.figures().worst_momentum_error);
  EXPECT_FALSE(recorder.figures().worst_momentum_angle_rad);
}

TEST(Figures, CountStepsPastBulletsCutWithoutTheStart) {
  FiguresRecorder recorder(sample_with(0, {100, 0, 0}, kSpin, 1.0), 0.1);
  recorder.add(sample_with(1, {7.85, 0, 0}, kSpin, 1.0));  // pi/4 in 0.1 s is 7.854 rad/s
  recorder.add(sample_with(2, {7.86, 0, 0}, kSpin, 1.0));
  EXPECT_EQ(recorder.figures().steps_past_cut, 1);
}

TEST(Figures, KeepTheLastAndTheWorstAttitudeErrorWhereThereIsOne) {
  const auto sample_off_by = [](std::int64_t step, std::optional<double> error_rad) {
    Sample sample = sample_with(step, kSpin, kSpin, 1.0);
    sample.attitude_error_rad = error_rad;
    return sample;
  };
  FiguresRecorder recorder(sample_off_by(0, 1e-19), 0.1);
  recorder.add(sample_off_by(1, 0.75));
  recorder.add(sample_off_by(2, 0.25));
  EXPECT_EQ(recorder.figures().worst_attitude_error_rad, 0.75);
  EXPECT_EQ(recorder.figures().final_attitude_error_rad, 0.25);

  FiguresRecorder without(sample_off_by(0, std::nullopt), 0.1);
  without.add(sample_off_by(1, std::nullopt));
  EXPECT_FALSE(without.figures().worst_attitude_error_rad);
  EXPECT_FALSE(without.figures().final_attitude_error_rad);
}

TEST(Figures, ShowASwollenBasis) {
  Sample swollen = sample_with(1, kSpin, kSpin, 1.0);
  swollen.state.R_WB *= 2.0;
  FiguresRecorder recorder(sample_with(0, kSpin, kSpin, 1.0), 0.1);
  EXPECT_EQ(recorder.figures().final_det_R, 1.0);
  recorder.add(swollen);
  EXPECT_EQ(recorder.figures().final_det_R, 8.0);
}

}  // namespace
}  // namespace polhode::demos
