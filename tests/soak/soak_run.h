#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "soak/memory.h"

namespace polhode::testing {

/// The largest change of free motion's constants since each body's start, relative.
struct Drift {
  double energy = 0;
  double angular_momentum = 0;
};

/// Collects what a soak finds and prints it.
class SoakRun {
 public:
  /// `heap_slack`: bytes that the heap may hold above those at a tenth of the run.
  SoakRun(std::string name, std::int64_t steps, std::int64_t heap_slack)
      : name_(std::move(name)), steps_(steps), heap_slack_(heap_slack) {}

  std::int64_t steps() const { return steps_; }
  /// Returns true a hundred times over the run.
  bool is_checkpoint(std::int64_t step) const { return step % (steps_ / 100) == 0; }

  /// Notes a violation; the first few are printed.
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

/// Ten million steps, or as many as asked for, of a few bodies in a RotationWorld.
bool soak_small_world(std::int64_t steps);

/// A thousand bodies under a RotationPlugin; bodies come and go and change, the plugin is detached and attached.
bool soak_changing_world(std::int64_t steps);

}  // namespace polhode::testing
