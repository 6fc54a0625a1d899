#include "viewer/model/history.h"

#include <algorithm>
#include <utility>

namespace polhode::demos {

void History::add(Snapshot snapshot) {
  snapshots_.push_back(std::move(snapshot));
  if (snapshots_.size() > capacity_) snapshots_.pop_front();
}

const Snapshot& History::at(std::int64_t step) const {
  const std::int64_t index = std::clamp(step, first_step(), last_step()) - first_step();
  return snapshots_[static_cast<std::size_t>(index)];
}

}  // namespace polhode::demos
