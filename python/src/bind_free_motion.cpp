#include "arguments.h"
#include "bindings.h"
#include "callbacks.h"
#include "free_motion.h"
#include "polhode/rotation_limits.h"
#include "python_scheme.h"
#include "signal_check.h"
#include "torque_law.h"
#include "trajectory.h"

namespace polhode::python {

namespace {

TorqueLawOrder read_law_order(int order) {
  if (order == 2) return TorqueLawOrder::two;
  if (order == 4) return TorqueLawOrder::four;
  throw py::value_error("order must be 2 or 4, is " + std::to_string(order));
}

std::int64_t read_count(std::int64_t count, const char* name) {
  constexpr std::int64_t most = 100'000'000;
  if (count >= 1 && count <= most) return count;
  throw py::value_error(std::string(name) + " must be a whole number from 1 to " + std::to_string(most) +
                        ", is " + std::to_string(count));
}

void require_scheme_takes(const FreeMotion& motion) {
  const SchemeDescription description = motion.scheme.description();
  const bool has_rotors = motion.start.has_rotor() || !motion.drive.rotor_torque_B.isZero(0.0);
  if (has_rotors && !description.takes_rotors) {
    throw py::value_error("scheme " + std::string(description.name) +
                          " takes no rotors; valid are those whose takes_rotors is True, such as exact");
  }
  if (!within_limits(motion.start)) {
    throw py::value_error("omega_W must be a start of at most " + std::to_string(kMaximumAngularSpeed) +
                          " rad/s, with a finite energy");
  }
}

// Returns the columns of Trajectory, and the step that diverged or None.
py::tuple free_motion(const SchemeHandle& scheme, const py::object& inertia_B, const RotationState& start,
                      double dt, std::int64_t steps, const py::object& torque_law, int order,
                      const py::object& rotor_torque_B, const py::object& position_W, std::int64_t every) {
  FreeMotion motion{
      *scheme.scheme,     read_inertia(inertia_B),    start, read_vector(position_W, "position_W"),
      read_time_step(dt), read_count(steps, "steps"), {}};
  motion.drive.law = read_law(torque_law);
  motion.drive.order = read_law_order(order);
  motion.drive.rotor_torque_B = read_vector(rotor_torque_B, "rotor_torque_B");
  require_scheme_takes(motion);
  Trajectory trajectory(read_count(every, "every"));
  Divergence diverged;
  try {
    const py::gil_scoped_release no_gil;
    SignalCheck check;
    diverged = run_free_motion(std::move(motion), [&](const demos::Sample& sample) {
      check();
      trajectory.add(sample);
    });
  } catch (...) {
    raise_kept_exception();  // which may be why
    throw;
  }
  raise_kept_exception();
  return py::make_tuple(trajectory.finish(), diverged ? py::object(py::int_(*diverged)) : py::none());
}

}  // namespace

void bind_free_motion(py::module_& module) {
  module.def("free_motion", &free_motion, py::arg("scheme"), py::arg("inertia_B"), py::arg("start"),
             py::arg("dt"), py::arg("steps"), py::arg("torque_law"), py::arg("order"),
             py::arg("rotor_torque_B"), py::arg("position_W"), py::arg("every"));
}

}  // namespace polhode::python
