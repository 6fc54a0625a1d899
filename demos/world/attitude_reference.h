#pragma once

#include <cstdint>
#include <memory>

#include "record/sample.h"
#include "scenario/scenario.h"

namespace polhode::oracle {
class FreeTop;
class TaylorTop;
}  // namespace polhode::oracle

namespace polhode::demos {

class ScenarioWorld;

/// Measures the angle between a sample and the exact motion. The exact motion starts from the body's own
/// state and uses its moments and time step, so that Bullet's rounding of the scenario does not count as an
/// error.
class AttitudeReference {
 public:
  AttitudeReference(const Scenario& scenario, const ScenarioWorld& world, const Sample& start);
  ~AttitudeReference();
  AttitudeReference(AttitudeReference&&) noexcept;
  AttitudeReference& operator=(AttitudeReference&&) noexcept;

  /// Sets the sample's attitude error if the exact motion is known. Samples must come in the order of their
  /// steps.
  void compare(Sample& sample);

 private:
  std::unique_ptr<const oracle::FreeTop> free_top_;
  std::unique_ptr<oracle::TaylorTop> top_with_rotors_;  ///< at the step of the last sample
  std::int64_t step_ = 0;
  double dt_s_;
};

}  // namespace polhode::demos
