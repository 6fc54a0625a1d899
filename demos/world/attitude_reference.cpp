#include "world/attitude_reference.h"

#include "support/oracle/free_top.h"
#include "world/scenario_world.h"

namespace polhode::demos {

AttitudeReference::AttitudeReference(const Scenario& scenario, const ScenarioWorld& world,
                                     const Sample& start)
    : dt_s_(world.dt_s()) {
  if (!scenario.is_torque_free()) return;
  free_top_ = std::make_unique<oracle::FreeTop>(world.inertia_B(), start.state.q_WB, start.state.L_W);
}

AttitudeReference::~AttitudeReference() = default;
AttitudeReference::AttitudeReference(AttitudeReference&&) noexcept = default;
AttitudeReference& AttitudeReference::operator=(AttitudeReference&&) noexcept = default;

void AttitudeReference::compare(Sample& sample) const {
  if (free_top_ == nullptr) return;
  sample.attitude_error_rad = free_top_->attitude_error_after(sample.state.q_WB, sample.step, dt_s_);
}

}  // namespace polhode::demos
