#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "record/sample.h"

namespace polhode::demos {

/// A run to be drawn: a record for the start, then one for each stretch of `stride` steps. Columns are all of
/// one length, but for those of vectors, which have their components one after the other. Single precision:
/// errors are taken in double first. What is not known is NaN.
struct Series {
  std::int64_t stride = 1;
  std::vector<float> t_s;

  /// @name At the end of the stretch
  /// @{
  std::vector<float> energy_J;
  std::vector<float> energy_x_J, energy_y_J, energy_z_J;  ///< rotational, about each body axis
  std::vector<float> det_R;
  std::vector<float> R_WB;  ///< nine, column by column
  std::vector<float> position_W;
  std::vector<float> omega_W;
  std::vector<float> L_W;
  std::vector<float> rotor_momentum_W;
  /// @}

  /// @name The one of largest magnitude in the stretch
  /// @{
  std::vector<float> energy_error;    ///< E/E0 - 1
  std::vector<float> momentum_error;  ///< |L|/|L0| - 1
  std::vector<float> momentum_angle_rad;
  std::vector<float> attitude_error_rad;
  /// @}

  std::vector<float> past_cut;  ///< how many of the stretch's steps turn by more than pi/4

  std::size_t records() const { return t_s.size(); }
};

/// Gathers the series of a run sample by sample, thinned to at most that many records beside the start.
class SeriesRecorder {
 public:
  SeriesRecorder(const Vector3& inertia_B, double dt, std::int64_t steps, std::size_t most_records);
  /// The start first.
  void add(const Sample& sample);
  /// Returns the series after the last sample. The last stretch of a run that diverged is shorter.
  Series finish();

 private:
  struct Errors {
    double energy;
    double momentum;
    double momentum_angle_rad;
    double attitude_rad;
  };

  Errors errors_of(const Sample& sample) const;
  void end_stretch(const Sample& sample);

  Vector3 inertia_B_;
  double dt_;
  Series series_;
  std::optional<Sample> start_;
  std::optional<Sample> last_;
  std::int64_t steps_in_stretch_ = 0;
  std::int64_t past_cut_ = 0;
  Errors worst_{};
};

}  // namespace polhode::demos
