#include <pybind11/operators.h>

#include "arguments.h"
#include "bindings.h"
#include "callbacks.h"
#include "polhode/torque_laws.h"
#include "torque_law.h"

namespace polhode::python {

namespace {

// Returns a torque of three numbers, which are in the world's axes, or of a Torque.
Torque read_torque(const py::object& result) {
  if (py::isinstance<Torque>(result)) return result.cast<Torque>();
  return WorldTorque{read_vector(result, "the torque that a law returns")};
}

// The exception of a law of Python's, which is kept meanwhile.
struct PythonFailed {};

// Calls `function` with the GIL. An exception in it is kept (callbacks.h).
template <class Function>
auto call_python(const Function& function) {
  const py::gil_scoped_acquire gil;
  try {
    return function();
  } catch (...) {
    keep_exception();
    throw PythonFailed();
  }
}

TorqueLaw law_of_python(const py::object& callable) {
  return [shared = share(callable)](const TorqueLawInput& motion) {
    return call_python([&] { return read_torque((*shared)(motion)); });
  };
}

LawHandle magnetic_dipole_law(const py::object& dipole_B, const py::object& field_W) {
  const Vector3 dipole = read_vector(dipole_B, "dipole_B");
  if (PyCallable_Check(field_W.ptr()) == 0) return {magnetic_dipole(dipole, read_vector(field_W, "field_W"))};
  return {magnetic_dipole_in_field(dipole, [shared = share(field_W)](const TorqueLawInput& motion) {
    return call_python([&] { return read_vector((*shared)(motion), "the field that field_W returns"); });
  })};
}

LawHandle rate_damping_law(const py::object& coefficients_B) {
  if (py::isinstance<py::float_>(coefficients_B) || py::isinstance<py::int_>(coefficients_B)) {
    return {rate_damping(coefficients_B.cast<double>())};
  }
  return {rate_damping(read_vector(coefficients_B, "coefficients_B"))};
}

Torque call_law(const LawHandle& law, const TorqueLawInput& motion) {
  try {
    return law.law(motion);
  } catch (const PythonFailed&) {
    raise_kept_exception();
    throw;
  }
}

void bind_motion(py::module_& module) {
  py::class_<TorqueLawInput>(module, "Motion", "What a torque law is asked about: a body at one moment.")
      .def(py::init([](const py::object& inertia_B, double time_s, const RotationState& state,
                       const py::object& position_W, const py::object& velocity_W) {
             return TorqueLawInput{time_s,
                                   state.q_WB,
                                   state.omega_W,
                                   read_vector(position_W, "position_W"),
                                   read_vector(velocity_W, "velocity_W"),
                                   read_inertia(inertia_B),
                                   state.rotor_momentum_B};
           }),
           py::kw_only(), py::arg("inertia_B"), py::arg("time_s"), py::arg("state"),
           py::arg("position_W") = 0, py::arg("velocity_W") = 0)
      .def_property_readonly("time_s", [](const TorqueLawInput& motion) { return motion.time_s; })
      .def_property_readonly("q_WB", [](const TorqueLawInput& motion) { return to_array(motion.q_WB); })
      .def_property_readonly(
          "R_WB",
          [](const TorqueLawInput& motion) { return to_array(Matrix3(motion.q_WB.toRotationMatrix())); })
      .def_property_readonly("omega_W", [](const TorqueLawInput& motion) { return to_array(motion.omega_W); })
      .def_property_readonly("omega_B",
                             [](const TorqueLawInput& motion) { return to_array(motion.omega_B()); })
      .def_property_readonly("position_W",
                             [](const TorqueLawInput& motion) { return to_array(motion.position_W); })
      .def_property_readonly("velocity_W",
                             [](const TorqueLawInput& motion) { return to_array(motion.velocity_W); })
      .def_property_readonly("inertia_B",
                             [](const TorqueLawInput& motion) { return to_array(motion.inertia_B); })
      .def_property_readonly("rotor_momentum_B",
                             [](const TorqueLawInput& motion) { return to_array(motion.rotor_momentum_B); });
}

void bind_torque(py::module_& module) {
  py::class_<Torque>(module, "Torque", "All that acts on a body at one moment, N m.")
      .def(py::init([](const py::object& world_W, const py::object& body_B, const py::object& rotor_B) {
             Torque torque;
             torque.world_W = read_vector(world_W, "world_W");
             torque.body_B = read_vector(body_B, "body_B");
             torque.rotor_B = read_vector(rotor_B, "rotor_B");
             return torque;
           }),
           py::kw_only(), py::arg("world_W") = 0, py::arg("body_B") = 0, py::arg("rotor_B") = 0)
      .def_property_readonly("world_W", [](const Torque& torque) { return to_array(torque.world_W); })
      .def_property_readonly("body_B", [](const Torque& torque) { return to_array(torque.body_B); })
      .def_property_readonly("rotor_B", [](const Torque& torque) { return to_array(torque.rotor_B); })
      .def(py::self + py::self)
      .def("__repr__", [](const Torque& torque) {
        return py::str("Torque(world_W={}, body_B={}, rotor_B={})")
            .format(to_array(torque.world_W), to_array(torque.body_B), to_array(torque.rotor_B));
      });
}

}  // namespace

TorqueLaw read_law(const py::object& law) {
  if (law.is_none()) return nullptr;
  if (py::isinstance<LawHandle>(law)) return law.cast<LawHandle>().law;
  if (PyCallable_Check(law.ptr()) != 0) return law_of_python(law);
  throw py::type_error(
      "torque_law must be a law of polhode.torque_laws, a callable of a motion, or None, is " +
      py::repr(law).cast<std::string>());
}

void bind_torque_laws(py::module_& module) {
  bind_motion(module);
  bind_torque(module);
  py::class_<LawHandle>(module, "TorqueLaw")
      .def("__call__", &call_law, py::arg("motion"))
      .def("__add__",
           [](const LawHandle& a, const py::object& other) {
             return LawHandle{[first = a.law, second = read_law(other)](const TorqueLawInput& motion) {
               return first(motion) + second(motion);
             }};
           })
      .def("__radd__", [](const LawHandle& b, const py::object& other) {
        return LawHandle{[first = read_law(other), second = b.law](const TorqueLawInput& motion) {
          return first(motion) + second(motion);
        }};
      });
  module.def(
      "gravity_gradient",
      [](double mu, const py::object& centre_W) {
        return LawHandle{gravity_gradient(mu, read_vector(centre_W, "centre_W"))};
      },
      py::arg("mu"), py::arg("centre_W") = 0);
  module.def("magnetic_dipole", &magnetic_dipole_law, py::arg("dipole_B"), py::arg("field_W"));
  module.def(
      "orientation_spring",
      [](const py::object& target_WB, double stiffness) {
        return LawHandle{orientation_spring(read_quaternion(target_WB, "target_WB"), stiffness)};
      },
      py::arg("target_WB"), py::arg("stiffness"));
  module.def("rate_damping", &rate_damping_law, py::arg("coefficients_B"));
  module.def(
      "internal_damping",
      [](double moment, double coefficient) { return LawHandle{internal_damping(moment, coefficient)}; },
      py::arg("moment"), py::arg("coefficient"));
}

}  // namespace polhode::python
