#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "record/contender.h"
#include "record/quantities.h"
#include "scenario/scenario.h"
#include "viewer/model/history.h"
#include "world/attitude_reference.h"
#include "world/scenario_world.h"

namespace polhode::demos {

/// The largest number of steps that can be recorded.
inline constexpr std::int64_t kMostDigests = 1000000;

/// One contender's world and its history.
class ContenderRun {
 public:
  ContenderRun(const Scenario& scenario, Contender contender, std::size_t history_capacity);

  /// Does nothing after the contender has diverged.
  void step();

  const Contender& contender() const { return contender_; }
  const History& history() const { return history_; }
  const Sample& start() const { return start_; }
  /// Returns the step that failed, if any.
  std::optional<std::int64_t> diverged_at_step() const { return diverged_at_step_; }
  /// Returns a digest of the state's bits after this step, for a recording; 0 if the run had diverged, or
  /// past kMostDigests.
  std::uint64_t digest_at(std::int64_t step) const;
  /// Returns the sample after this step, or after the nearest step that is kept.
  Instant instant(std::int64_t step) const { return {history_.at(step).sample, start_, inertia_B()}; }
  Vector3 inertia_B() const { return world_->inertia_B(); }

 private:
  void keep(Snapshot snapshot);
  std::vector<Pose> other_poses() const;

  Contender contender_;
  std::size_t other_count_;
  std::unique_ptr<ScenarioWorld> world_;
  Sample start_;
  AttitudeReference reference_;
  History history_;
  std::vector<std::uint64_t> digests_;
  std::optional<std::int64_t> diverged_at_step_;
};

}  // namespace polhode::demos
