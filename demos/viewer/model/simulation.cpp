#include "viewer/model/simulation.h"

#include <algorithm>
#include <utility>

namespace polhode::demos {

Simulation::Simulation(Scenario scenario, const std::vector<Contender>& contenders,
                       std::size_t history_capacity)
    : scenario_(std::move(scenario)),
      history_capacity_(
          std::min(history_capacity, kMostPoses / ((scenario_.others.size() + 1) * contenders.size()))) {
  for (const Contender& contender : contenders) {
    runs_.push_back(std::make_unique<ContenderRun>(scenario_, contender, history_capacity_));
  }
}

std::vector<std::string> Simulation::step() {
  ++shown_step_;
  const bool is_new = shown_step_ > computed_step_;
  computed_step_ = std::max(computed_step_, shown_step_);
  std::vector<std::string> diverged;
  for (const auto& run : runs_) {
    if (is_new) run->step();
    if (run->diverged_at_step() == shown_step_) diverged.push_back(run->contender().name);
  }
  return diverged;
}

bool Simulation::step_back() {
  if (shown_step_ <= first_kept_step()) return false;
  --shown_step_;
  return true;
}

std::int64_t Simulation::first_kept_step() const {
  // A run that has diverged may keep older steps than the others.
  const auto capacity = static_cast<std::int64_t>(history_capacity_);
  return std::max<std::int64_t>(0, computed_step_ - capacity + 1);
}

bool Simulation::all_diverged() const {
  return std::all_of(runs_.begin(), runs_.end(),
                     [](const auto& run) { return run->diverged_at_step().has_value(); });
}

bool Simulation::has_diverged(std::size_t index) const {
  const std::optional<std::int64_t> step = run(index).diverged_at_step();
  return step && *step <= shown_step_;
}

}  // namespace polhode::demos
