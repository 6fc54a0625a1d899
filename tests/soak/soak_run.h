#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "soak/memory.h"

namespace polhode::testing {

/// The largest relative change of energy and angular momentum since each body's start.
struct Drift {
  double energy = 0;
  double angular_momentum = 0;
};

/// Collects and prints the results of a soak test.
class SoakRun {
 public:
  /// `heap_slack`: allowed growth of the heap after a tenth of the run, in bytes.
  SoakRun(std::string name, std::int64_t steps, std::int64_t heap_slack)
      : name_(std::move(name)), steps_(steps), heap_slack_(heap_slack) {}

  std::int64_t steps() const { return steps_; }
  /// Returns true at a hundred steps, evenly spaced over the run.
  bool is_checkpoint(std::int64_t step) const { return step % (steps_ / 100) == 0; }

  /// Records a violation; prints the first few.
  void require(bool holds, std::int64_t step, const std::string& what);
  /// Checks memory and drift at a checkpoint, and prints a row at 10 %, 50 % and 100 % of the run.
  void check(std::int64_t step, const Drift& drift, std::size_t managed_bodies);

  bool passed() const { return violations_ == 0; }

 private:
  std::string name_;
  std::int64_t steps_;
  std::int64_t heap_slack_;
  std::optional<Memory> at_tenth_;
  std::int64_t violations_ = 0;
};

/// Steps a few bodies in a RotationWorld.
bool soak_small_world(std::int64_t steps);

/// Steps a thousand bodies under a RotationPlugin. Bodies come, go and change; the plugin is detached and
/// attached.
bool soak_changing_world(std::int64_t steps);

}  // namespace polhode::testing
