#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "record/quantities.h"

namespace polhode::demos {

/// The part of a run that is drawn: a record for the start, then one for every `stride` steps. Single
/// precision suffices, since errors are computed in double first.
struct Series {
  std::int64_t stride = 1;
  /// The quantities of the report, by key. A record has the value at the end of its steps, or for an error
  /// the largest. The components of a vector follow each other. NaN is an unknown value.
  std::map<std::string_view, std::vector<float>> columns;
  std::vector<float> past_cut;  ///< number of a record's steps that turn by more than pi/4

  std::size_t records() const { return past_cut.size(); }
};

/// Gathers the series of a run sample by sample, thinned to at most this many records after the start.
class SeriesRecorder {
 public:
  SeriesRecorder(const Vector3& inertia_B, double dt, std::int64_t steps, std::size_t most_records);
  /// Add the start first.
  void add(const Sample& sample);
  /// Returns the series after the last sample. The last record of a run that diverged covers fewer steps.
  Series finish();

 private:
  void add_to_stretch(const Sample& sample);
  void end_stretch();

  Vector3 inertia_B_;
  double dt_;
  Series series_;
  std::optional<Sample> start_;
  std::vector<double> record_;  ///< the record in progress, all components one after the other
  std::int64_t steps_in_stretch_ = 0;
  std::int64_t past_cut_ = 0;
};

}  // namespace polhode::demos
