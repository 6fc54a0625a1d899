#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "record/sample.h"

namespace polhode::demos {

/// The place and orientation of a body that is not recorded.
struct Pose {
  Matrix3 R_WB = Matrix3::Identity();
  Vector3 position_W = Vector3::Zero();
};

/// The values from which one contender is drawn after one step.
struct Snapshot {
  Sample sample;
  std::vector<Pose> others;
};

/// The last steps of one contender, without a gap. It holds a bounded number of them: the oldest give way.
class History {
 public:
  explicit History(std::size_t capacity) : capacity_(capacity) {}

  /// The step after the last one.
  void add(Snapshot snapshot);
  std::int64_t first_step() const { return snapshots_.front().sample.step; }
  std::int64_t last_step() const { return snapshots_.back().sample.step; }
  std::size_t size() const { return snapshots_.size(); }

  /// The snapshot of that step, or of the nearest that is held: after a divergence the last sound one.
  const Snapshot& at(std::int64_t step) const;

 private:
  std::size_t capacity_;
  std::deque<Snapshot> snapshots_;
};

}  // namespace polhode::demos
