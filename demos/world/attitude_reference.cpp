#include "world/attitude_reference.h"

#include "oracle/free_top.h"
#include "oracle/taylor_top.h"
#include "world/scenario_world.h"

namespace polhode::demos {

AttitudeReference::AttitudeReference(const Scenario& scenario, const ScenarioWorld& world,
                                     const Sample& start)
    : dt_s_(world.dt_s()) {
  if (!scenario.is_torque_free()) return;
  if (scenario.body.drive.has_rotors()) {
    top_with_rotors_ = std::make_unique<oracle::TaylorTop>(world.inertia_B(), start.state.q_WB,
                                                           start.state.L_W, start.state.rotor_momentum_B);
  } else {
    free_top_ = std::make_unique<oracle::FreeTop>(world.inertia_B(), start.state.q_WB, start.state.L_W);
  }
}

AttitudeReference::~AttitudeReference() = default;
AttitudeReference::AttitudeReference(AttitudeReference&&) noexcept = default;
AttitudeReference& AttitudeReference::operator=(AttitudeReference&&) noexcept = default;

void AttitudeReference::compare(Sample& sample) {
  if (free_top_ != nullptr) {
    sample.attitude_error_rad = free_top_->attitude_error_after(sample.state.q_WB, sample.step, dt_s_);
  } else if (top_with_rotors_ != nullptr) {
    top_with_rotors_->advance(static_cast<double>(sample.step - step_) * dt_s_);
    step_ = sample.step;
    sample.attitude_error_rad = top_with_rotors_->attitude_error(sample.state.q_WB);
  }
}

}  // namespace polhode::demos
