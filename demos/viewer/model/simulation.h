#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/model/contender_run.h"

namespace polhode::demos {

/// The number of steps kept of each contender, for stepping back and for plots.
inline constexpr std::size_t kHistoryCapacity = 20000;
/// Fewer steps are kept if the bodies of all contenders would have more poses than this, of 96 bytes each.
inline constexpr std::size_t kMostPoses = 4000000;

/// A scenario run by several contenders in lockstep: all are at the same step, or have diverged before. The
/// step shown can lie behind the last one computed, as far back as the history goes.
class Simulation {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses
  Simulation(Scenario scenario, const std::vector<Contender>& contenders,
             std::size_t history_capacity = kHistoryCapacity);

  /// Shows the next step, and computes it if needed. Returns the names of the contenders that diverge in it.
  std::vector<std::string> step();
  /// Shows the step before. Returns false if that is not kept.
  bool step_back();

  const Scenario& scenario() const { return scenario_; }
  std::int64_t shown_step() const { return shown_step_; }
  double shown_t_s() const { return static_cast<double>(shown_step_) * scenario_.dt; }
  std::int64_t computed_step() const { return computed_step_; }
  std::int64_t first_kept_step() const;
  std::size_t history_capacity() const { return history_capacity_; }
  bool all_diverged() const;

  std::size_t size() const { return runs_.size(); }
  const ContenderRun& run(std::size_t index) const { return *runs_.at(index); }
  const Snapshot& shown(std::size_t index) const { return run(index).history().at(shown_step_); }
  /// Returns true if this contender has failed at or before the step shown.
  bool has_diverged(std::size_t index) const;

 private:
  Scenario scenario_;
  std::vector<std::unique_ptr<ContenderRun>> runs_;
  std::int64_t shown_step_ = 0;
  std::int64_t computed_step_ = 0;
  std::size_t history_capacity_;
};

}  // namespace polhode::demos
