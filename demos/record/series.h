#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "record/quantities.h"

namespace polhode::demos {

/// A run to be drawn: a record for the start, then one for each stretch of `stride` steps. Single precision: errors
/// are taken in double first.
struct Series {
  std::int64_t stride = 1;
  /// By key, those quantities that are in the report. A record has the value at the end of its stretch, of an error the
  /// largest in the stretch; a vector's components follow each other; NaN: not known.
  std::map<std::string_view, std::vector<float>> columns;
  std::vector<float> past_cut;  ///< how many of the stretch's steps turn by more than pi/4

  std::size_t records() const { return past_cut.size(); }
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
  void add_to_stretch(const Sample& sample);
  void end_stretch();

  Vector3 inertia_B_;
  double dt_;
  Series series_;
  std::optional<Sample> start_;
  std::vector<double> record_;  ///< of the stretch so far, all components one after the other
  std::int64_t steps_in_stretch_ = 0;
  std::int64_t past_cut_ = 0;
};

}  // namespace polhode::demos
