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

/// Measures the distance of a sample from the exact motion. The exact motion starts from the body's own
/// values, with the moments and the time step that it really has: Bullet's rounding of the scenario is no
/// error of the contender's.
class AttitudeReference {
 public:
  AttitudeReference(const Scenario& scenario, const ScenarioWorld& world, const Sample& start);
  ~AttitudeReference();
  AttitudeReference(AttitudeReference&&) noexcept;
  AttitudeReference& operator=(AttitudeReference&&) noexcept;

  /// Sets the sample's attitude error, where the exact motion is known. Samples must come in the order of their steps.
  void compare(Sample& sample);

 private:
  std::unique_ptr<const oracle::FreeTop> free_top_;
  std::unique_ptr<oracle::TaylorTop> top_with_rotors_;  ///< at the step of the last sample
  std::int64_t step_ = 0;
  double dt_s_;
};

}  // namespace polhode::demos
