#pragma once

#include <algorithm>

#include "lanes/lanes.h"
#include "polhode/rotation_scheme.h"

namespace polhode {

/// Up to eight bodies of a step_bodies, and the way between them and lanes. With fewer than eight the last
/// one fills the lanes that are left.
class LaneBlock {
 public:
  LaneBlock(const BodyStep* bodies, std::size_t count) : bodies_(bodies), count_(count) {}

  std::size_t count() const { return count_; }
  const BodyStep& body(std::size_t lane) const { return bodies_[std::min(lane, count_ - 1)]; }

  /// `get(body)` is a fixed-size Eigen vector or matrix of doubles; the result is one of Lanes.
  template <class Get>
  auto load(Get get) const {
    using Matrix = std::decay_t<decltype(get(body(0)))>;
    Eigen::Matrix<Lanes, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime> result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto& values = get(body(lane));
      for (int i = 0; i < Matrix::SizeAtCompileTime; ++i) result.coeffRef(i).set(lane, values.coeff(i));
    }
    return result;
  }

  /// The same for one double.
  template <class Get>
  Lanes load_scalar(Get get) const {
    Lanes result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result.set(lane, get(body(lane)));
    return result;
  }

  /// `get(body)` is a reference to what each body gets of `values`.
  template <class Values, class Get>
  void store(const Values& values, Get get) const {
    for (std::size_t lane = 0; lane < count_; ++lane) {
      auto& result = get(body(lane));
      for (int i = 0; i < Values::SizeAtCompileTime; ++i) result.coeffRef(i) = values.coeff(i)[lane];
    }
  }

 private:
  const BodyStep* bodies_;
  std::size_t count_;
};

/// Calls `step_block(block)` for all the bodies, eight at a time.
template <class StepBlock>
void in_blocks(const BodyStep* bodies, std::size_t count, StepBlock step_block) {
  for (std::size_t first = 0; first < count; first += kLanes) {
    step_block(LaneBlock(bodies + first, std::min(kLanes, count - first)));
  }
}

}  // namespace polhode
