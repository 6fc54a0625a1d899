#include "record/series.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode::demos {
namespace {

constexpr double kDt = 0.1;
const Vector3 kInertia(1, 2, 4);

// Returns a spin at this speed, rad/s, about the body's x axis, with kInertia.
Sample sample_at(std::int64_t step, double speed = 2.0) {
  Sample sample;
  sample.step = step;
  sample.t_s = kDt * static_cast<double>(step);
  sample.state.omega_W = {speed, 0, 0};
  sample.state.L_W = {speed, 0, 0};
  sample.energy_J = sample.state.energy();
  sample.attitude_error_rad = 0.0;
  return sample;
}

const std::vector<float>& column(const Series& series, const char* key) {
  return series.columns.at(key);
}

Series recorded(std::int64_t steps, std::size_t most_records, std::int64_t last_step) {
  SeriesRecorder recorder(kInertia, kDt, steps, most_records);
  for (std::int64_t step = 0; step <= last_step; ++step) recorder.add(sample_at(step));
  return recorder.finish();
}

TEST(Series, HoldsEveryStepOfAShortRun) {
  const Series series = recorded(7, 10, 7);
  EXPECT_EQ(series.stride, 1);
  ASSERT_EQ(series.records(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(column(series, "t_s")[i], static_cast<float>(kDt * static_cast<double>(i)));
  EXPECT_EQ(column(series, "R_WB").size(), 9 * 8u);
  EXPECT_EQ(column(series, "position_W").size(), 3 * 8u);
  EXPECT_EQ(column(series, "omega_W").size(), 3 * 8u);
  EXPECT_EQ(column(series, "L_W").size(), 3 * 8u);
}

TEST(Series, ThinsALongRunToItsMost) {
  for (const std::int64_t steps : {10, 11, 99, 100, 101, 1000}) {
    const Series series = recorded(steps, 10, steps);
    EXPECT_LE(series.records(), 11u) << steps;
    EXPECT_GE(series.records(), 6u) << steps;
    EXPECT_EQ(column(series, "t_s").front(), 0.0F);
    EXPECT_EQ(column(series, "t_s").back(), static_cast<float>(kDt * static_cast<double>(steps)));
  }
}

TEST(Series, EndsWhereARunDiverged) {
  const Series series = recorded(100, 10, 33);
  EXPECT_EQ(series.stride, 10);
  EXPECT_EQ(column(series, "t_s"), (std::vector<float>{0.0F, 1.0F, 2.0F, 3.0F, 3.3F}));
}

TEST(Series, LosesNoPeakOfAnError) {
  SeriesRecorder recorder(kInertia, kDt, 100, 10);
  for (std::int64_t step = 0; step <= 100; ++step) {
    Sample sample = sample_at(step);
    if (step == 34) {
      sample.energy_J *= 0.25;
      sample.state.L_W = {0, 1, 0};
      sample.attitude_error_rad = 3.0;
    }
    recorder.add(sample);
  }
  const Series series = recorder.finish();
  for (std::size_t i = 0; i < series.records(); ++i) {
    const bool is_peak = i == 4;  // steps 31 to 40
    EXPECT_EQ(column(series, "energy_error")[i], is_peak ? -0.75F : 0.0F) << i;
    EXPECT_EQ(column(series, "momentum_error")[i], is_peak ? -0.5F : 0.0F) << i;
    EXPECT_EQ(column(series, "momentum_angle_rad")[i], is_peak ? static_cast<float>(std::acos(0.0)) : 0.0F)
        << i;
    EXPECT_EQ(column(series, "attitude_error_rad")[i], is_peak ? 3.0F : 0.0F) << i;
  }
}

TEST(Series, TakesRotorsForAPartOfTheMomentumAndOfNoEnergy) {
  SeriesRecorder recorder(kInertia, kDt, 1, 10);
  Sample sample = sample_at(0);
  sample.state.q_WB = Quaternion(0, 0, 0, 1);
  sample.state.R_WB = sample.state.q_WB.toRotationMatrix();
  sample.state.rotor_momentum_B = {1, 2, 3};
  sample.state.L_W += sample.state.R_WB * sample.state.rotor_momentum_B;
  recorder.add(sample);
  const Series series = recorder.finish();
  EXPECT_EQ(column(series, "rotor_momentum_W"), (std::vector<float>{-1, -2, 3}));
  EXPECT_EQ(column(series, "axis_energy_J")[0], 2.0F);
  EXPECT_EQ(column(series, "axis_energy_J")[1], 0.0F);
  EXPECT_EQ(column(series, "axis_energy_J")[2], 0.0F);
}

TEST(Series, SplitsTheRotationalEnergyByTheBodysAxes) {
  SeriesRecorder recorder(kInertia, kDt, 1, 10);
  Sample sample = sample_at(0);
  sample.state.R_WB = 1.5 * Quaternion(1, 2, 3, 4).normalized().toRotationMatrix();  // swollen
  sample.state.L_W = {3, -1, 2};
  sample.state.omega_W =
      sample.state.R_WB * (sample.state.R_WB.transpose() * sample.state.L_W).cwiseQuotient(kInertia);
  recorder.add(sample);
  const Series series = recorder.finish();
  // measured 0 and 6e-8 of 6.9
  EXPECT_NEAR(column(series, "axis_energy_J")[0] + column(series, "axis_energy_J")[1] +
                  column(series, "axis_energy_J")[2],
              sample.state.energy(), 1e-6);
  EXPECT_GT(column(series, "axis_energy_J")[1], 0.0F);
}

TEST(Series, CountsStepsPastBulletsCutByStretches) {
  SeriesRecorder recorder(kInertia, kDt, 20, 2);
  for (std::int64_t step = 0; step <= 20; ++step) recorder.add(sample_at(step, step % 4 == 0 ? 7.86 : 7.85));
  // pi/4 in 0.1 s is 7.854 rad/s; the start does not count
  EXPECT_EQ(recorder.finish().past_cut, (std::vector<float>{0.0F, 2.0F, 3.0F}));
}

TEST(Series, SaysWhatIsNotKnown) {
  SeriesRecorder recorder(kInertia, kDt, 2, 10);
  Sample at_rest = sample_at(0, 0.0);
  at_rest.attitude_error_rad = std::nullopt;
  recorder.add(at_rest);
  recorder.add(at_rest);
  const Series series = recorder.finish();
  for (const char* key : {"energy_error", "momentum_error", "momentum_angle_rad", "attitude_error_rad"}) {
    for (const float error : column(series, key)) EXPECT_TRUE(std::isnan(error)) << key;
  }
}

}  // namespace
}  // namespace polhode::demos
