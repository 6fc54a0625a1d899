#include "soak/soak_run.h"

#include <cinttypes>
#include <cstdio>
#include <sstream>

namespace polhode::testing {

namespace {

// Relative; for bodies with `exact`.
constexpr double kEnergyBound = 2e-14;       // measured 2.1e-15
constexpr double kAngularMomentumBound = 0;  // constant to the last bit
// Allowed growth since a tenth of the run.
constexpr std::int64_t kResidentSlack = 4 * 1024 * 1024;  // measured 0.7 MiB
constexpr std::int64_t kPrintedViolations = 10;

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

void SoakRun::require(bool holds, std::int64_t step, const std::string& what) {
  if (holds) return;
  if (++violations_ <= kPrintedViolations) {
    std::printf("%s, step %" PRId64 ": VIOLATION: %s\n", name_.c_str(), step, what.c_str());
  }
}

void SoakRun::check(std::int64_t step, const Drift& drift, std::size_t managed_bodies) {
  const Memory memory = memory_now();
  if (step == steps_ / 10) at_tenth_ = memory;
  if (at_tenth_.has_value()) {
    require(memory.heap_bytes <= at_tenth_->heap_bytes + heap_slack_, step, "the heap grows");
    require(memory.resident_bytes <= at_tenth_->resident_bytes + kResidentSlack, step,
            "resident memory grows");
  }
  require(drift.energy <= kEnergyBound, step, "the energy of free bodies drifts by " + text_of(drift.energy));
  require(drift.angular_momentum <= kAngularMomentumBound, step,
          "the angular momentum of free bodies drifts by " + text_of(drift.angular_momentum));
  if (step != steps_ / 10 && step != steps_ / 2 && step != steps_) return;
  std::printf("%-15s %10" PRId64 " %8zu %12" PRId64 " %14.1f %10.1e %10.1e\n", name_.c_str(), step,
              managed_bodies, memory.heap_bytes, static_cast<double>(memory.resident_bytes) / 1048576,
              drift.energy, drift.angular_momentum);
  std::fflush(stdout);
}

}  // namespace polhode::testing
