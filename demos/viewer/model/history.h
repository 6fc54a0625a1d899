#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "record/sample.h"

namespace polhode::demos {

/// The pose of a body that is not recorded.
struct Pose {
  Matrix3 R_WB = Matrix3::Identity();
  Vector3 position_W = Vector3::Zero();
};

/// The values needed to draw one contender after one step.
struct Snapshot {
  Sample sample;
  std::vector<Pose> others;
};

/// The last steps of one contender, without a gap. Keeps a limited number of steps and drops the oldest.
class History {
 public:
  explicit History(std::size_t capacity) : capacity_(capacity) {}

  /// Returns the step after the last one.
  void add(Snapshot snapshot);
  std::int64_t first_step() const { return snapshots_.front().sample.step; }
  std::int64_t last_step() const { return snapshots_.back().sample.step; }
  std::size_t size() const { return snapshots_.size(); }

  /// Returns the snapshot of this step, or of the nearest step kept: after a divergence the last valid one.
  const Snapshot& at(std::int64_t step) const;

 private:
  std::size_t capacity_;
  std::deque<Snapshot> snapshots_;
};

}  // namespace polhode::demos
