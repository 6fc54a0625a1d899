#include "arguments.h"
#include "bindings.h"
#include "math/polar.h"
#include "polhode/rotation_math.h"

namespace polhode::python {

namespace {

constexpr char kDoc[] = R"(The rotation of one body at one moment. It cannot be changed.

Give one of q_WB and R_WB (the identity if there is neither), and one of omega_W and L_W (at rest if there is
neither); the other two follow. W is the world's frame, B the body's: its origin is the centre of
mass, its axes are principal axes.

inertia_B         (3,)    principal moments, kg m^2, each above 0
q_WB              (4,)    orientation, a quaternion w, x, y, z: v_W = q_WB v_B; made a unit one
R_WB              (3, 3)  its matrix. Of one that is no rotation, q_WB is the nearest rotation
omega_W           (3,)    angular velocity, rad/s
L_W               (3,)    angular momentum with that of rotors, kg m^2/s
rotor_momentum_B  (3,)    the part of it that rotors inside the body carry

Raises ValueError or TypeError that says what is valid.)";

void require_one_of(const py::object& a, const py::object& b, const char* names) {
  if (!a.is_none() && !b.is_none()) throw py::type_error(std::string("give one of ") + names + ", not both");
}

RotationState make_state(const py::object& inertia, const py::object& q_WB, const py::object& R_WB,
                         const py::object& omega_W, const py::object& L_W,
                         const py::object& rotor_momentum_B) {
  const Vector3 inertia_B = read_inertia(inertia);
  require_one_of(q_WB, R_WB, "q_WB and R_WB");
  require_one_of(omega_W, L_W, "omega_W and L_W");
  RotationState state;
  if (!q_WB.is_none()) set_orientation(state, read_quaternion(q_WB, "q_WB"));
  if (!R_WB.is_none()) {
    state.R_WB = read_matrix(R_WB, "R_WB");
    if (state.R_WB.determinant() <= 0.0) throw py::value_error("R_WB must have a determinant above 0");
    state.q_WB = formulas::nearest_rotation<double>(state.R_WB, Quaternion::Identity());
  }
  state.rotor_momentum_B = read_vector(rotor_momentum_B, "rotor_momentum_B");
  if (!L_W.is_none()) {
    set_angular_momentum(state, inertia_B, read_vector(L_W, "L_W"));
  } else {
    const Vector3 omega = omega_W.is_none() ? Vector3(Vector3::Zero()) : read_vector(omega_W, "omega_W");
    set_omega(state, inertia_B, omega);
    // of a matrix that is no rotation
    if (!R_WB.is_none()) state.L_W = with_rotor(state, angular_momentum_W(state.R_WB, inertia_B, omega));
  }
  return state;
}

std::string text_of(const RotationState& state) {
  return py::str("State(q_WB={}, omega_W={}, L_W={})")
      .format(to_array(state.q_WB), to_array(state.omega_W), to_array(state.L_W))
      .cast<std::string>();
}

}  // namespace

void bind_state(py::module_& module) {
  py::class_<RotationState>(module, "State", kDoc)
      .def(py::init(&make_state), py::arg("inertia_B"), py::kw_only(), py::arg("q_WB") = py::none(),
           py::arg("R_WB") = py::none(), py::arg("omega_W") = py::none(), py::arg("L_W") = py::none(),
           py::arg("rotor_momentum_B") = 0)
      .def_property_readonly("q_WB", [](const RotationState& state) { return to_array(state.q_WB); })
      .def_property_readonly("R_WB", [](const RotationState& state) { return to_array(state.R_WB); })
      .def_property_readonly("omega_W", [](const RotationState& state) { return to_array(state.omega_W); })
      .def_property_readonly("L_W", [](const RotationState& state) { return to_array(state.L_W); })
      .def_property_readonly("rotor_momentum_B",
                             [](const RotationState& state) { return to_array(state.rotor_momentum_B); })
      .def_property_readonly("energy_J", &RotationState::energy,
                             "Rotational kinetic energy of the body without that of its rotors, J.")
      .def_property_readonly("det_R", [](const RotationState& state) { return state.R_WB.determinant(); })
      .def("__repr__", &text_of);
  module.def(
      "exponential", [](const py::object& v) { return to_array(exponential(read_vector(v, "v"))); },
      py::arg("v"));
  module.def(
      "multiply",
      [](const py::object& p, const py::object& q) {
        return to_array(Quaternion(read_quaternion(p, "p") * read_quaternion(q, "q")));
      },
      py::arg("p"), py::arg("q"));
  module.def(
      "logarithm", [](const py::object& q) { return to_array(logarithm(read_quaternion(q, "q"))); },
      py::arg("q"));
}

}  // namespace polhode::python
