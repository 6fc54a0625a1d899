#include "viewer/model/changes.h"

#include <stdexcept>
#include <string>

#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

constexpr Range kComponentRange{-1e9, 1e9};

void check(const std::string& what, double value, const Range& range) {
  if (range.contains(value)) return;
  throw std::invalid_argument(what + " must be " + range_text(range) + ", is " + short_number_text(value, 6));
}

}  // namespace

Changes changes_of(const Scenario& resolved_scenario) {
  return {resolved_scenario.dt, resolved_scenario.body.inertia_B.value(), resolved_scenario.body.omega_W};
}

Scenario changed(Scenario scenario, const Changes& changes) {
  check("dt", changes.dt, kDtRange);
  for (int axis = 0; axis < 3; ++axis) {
    check("inertia", changes.inertia_B[axis], kInertiaRange);
    check("angular velocity", changes.omega_W[axis], kComponentRange);
  }
  scenario.dt = changes.dt;
  scenario.body.inertia_B = changes.inertia_B;
  scenario.body.omega_W = changes.omega_W;
  return scenario;
}

}  // namespace polhode::demos
