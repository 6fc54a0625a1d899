#include "arguments.h"
#include "bindings.h"
#include "python_scheme.h"

namespace polhode::python {

namespace {

const char* conservation_text(Conservation conservation) {
  switch (conservation) {
    case Conservation::exact:
      return "exact";
    case Conservation::bounded:
      return "bounded";
    case Conservation::lost:
      break;
  }
  return "lost";
}

py::dict description_of(const SchemeHandle& handle) {
  const SchemeDescription description = handle.scheme->description();
  py::dict result;
  result["name"] = description.name;
  result["summary"] = description.summary;
  result["source"] = description.source;
  result["fails_when"] = description.fails_when;
  result["order"] = description.order ? py::object(py::int_(*description.order)) : py::none();
  result["energy"] = conservation_text(description.energy);
  result["angular_momentum"] = conservation_text(description.angular_momentum);
  result["rotation"] = conservation_text(description.rotation);
  result["takes_rotors"] = description.takes_rotors;
  return result;
}

// A step that C++ makes, for Python.
RotationState step(const SchemeHandle& handle, const py::object& inertia_B, const RotationState& state,
                   double dt, const py::object& delta_omega_W) {
  const SchemeDescription description = handle.scheme->description();
  if (state.has_rotor() && !description.takes_rotors) {
    throw py::value_error("scheme " + std::string(description.name) +
                          " takes no rotors; valid is a state whose rotor_momentum_B is 0");
  }
  RotationState end = state;
  handle.scheme->step(
      {read_inertia(inertia_B), read_vector(delta_omega_W, "delta_omega_W"), read_time_step(dt)}, end);
  raise_kept_exception();
  return end;
}

py::list handles_of(const std::vector<SchemePointer>& schemes) {
  py::list handles;
  for (const SchemePointer& scheme : schemes) handles.append(SchemeHandle{scheme});
  return handles;
}

}  // namespace

void bind_schemes(py::module_& module) {
  py::class_<SchemeHandle>(module, "SchemeHandle")
      .def("describe", &description_of)
      .def("step", &step, py::arg("inertia_B"), py::arg("state"), py::arg("dt"), py::arg("delta_omega_W") = 0)
      .def("python_object", [](const SchemeHandle& handle) { return python_object(*handle.scheme); });
  module.def(
      "make_scheme", [](const py::object& scheme) { return SchemeHandle{make_python_scheme(scheme)}; },
      py::arg("scheme"));
  module.def(
      "register_scheme", [](const SchemeHandle& handle) { register_scheme(handle.scheme); },
      py::arg("scheme"));
  module.def(
      "find_scheme", [](const std::string& name) { return SchemeHandle{find_scheme(name)}; },
      py::arg("name"));
  module.def("all_schemes", [] { return handles_of(all_schemes()); });
  module.def("registered_schemes", [] {
    std::vector<SchemePointer> registered = all_schemes();
    registered.erase(registered.begin(), registered.begin() + std::ptrdiff_t(built_in_schemes().size()));
    return handles_of(registered);
  });
}

}  // namespace polhode::python
