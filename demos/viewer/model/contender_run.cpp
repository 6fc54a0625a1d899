#include "viewer/model/contender_run.h"

#include <utility>

#include "viewer/model/digest.h"
#include "world/conversions.h"

namespace polhode::demos {

ContenderRun::ContenderRun(const Scenario& scenario, Contender contender, std::size_t history_capacity)
    : contender_(std::move(contender)),
      other_count_(scenario.others.size()),
      world_(std::make_unique<ScenarioWorld>(scenario, contender_)),
      start_(world_->sample().value()),
      reference_(scenario, *world_, start_),
      history_(history_capacity) {
  reference_.compare(start_);
  keep({start_, other_poses()});
}

void ContenderRun::step() {
  if (diverged_at_step_) return;
  world_->step();
  std::optional<Sample> sample = world_->sample();
  if (!sample) {
    diverged_at_step_ = history_.last_step() + 1;
    return;
  }
  reference_.compare(*sample);
  keep({*sample, other_poses()});
}

std::uint64_t ContenderRun::digest_at(std::int64_t step) const {
  const auto index = static_cast<std::size_t>(step);
  return index < digests_.size() ? digests_[index] : 0;
}

void ContenderRun::keep(Snapshot snapshot) {
  if (snapshot.sample.step <= kMostDigests) digests_.push_back(digest_of(snapshot));
  history_.add(std::move(snapshot));
}

std::vector<Pose> ContenderRun::other_poses() const {
  std::vector<Pose> poses;
  for (std::size_t index = 1; index <= other_count_; ++index) {
    const btTransform& pose_WB = world_->body(index).getWorldTransform();
    poses.push_back({from_bullet(pose_WB.getBasis()), from_bullet(pose_WB.getOrigin())});
  }
  return poses;
}

}  // namespace polhode::demos
