#include "python_scheme.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "arguments.h"

namespace polhode::python {

namespace {

std::string read_text(const py::object& object, const char* attribute) {
  const py::object value = object.attr(attribute);
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  throw py::type_error(std::string(attribute) + " of a scheme must be a str, is " +
                       py::repr(value).cast<std::string>());
}

std::string read_name(const py::object& object) {
  std::string name = read_text(object, "name");
  const bool plain = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!name.empty() && name.front() >= 'a' && name.front() <= 'z' && plain) return name;
  throw py::value_error("name of a scheme must be of the form [a-z][a-z0-9_]*, is \"" + name + "\"");
}

std::optional<int> read_order(const py::object& object) {
  const py::object value = object.attr("order");
  if (value.is_none()) return std::nullopt;
  if (py::isinstance<py::int_>(value) && value.cast<long>() >= 1 && value.cast<long>() <= 100) {
    return value.cast<int>();
  }
  throw py::value_error("order of a scheme must be a whole number from 1 to 100, or None for exact, is " +
                        py::repr(value).cast<std::string>());
}

Conservation read_conservation(const py::object& object, const char* attribute) {
  const std::string text = read_text(object, attribute);
  if (text == "exact") return Conservation::exact;
  if (text == "bounded") return Conservation::bounded;
  if (text == "lost") return Conservation::lost;
  throw py::value_error(std::string(attribute) +
                        " of a scheme must be \"exact\", \"bounded\" or \"lost\", is \"" + text + "\"");
}

class PythonScheme final : public RotationScheme {
 public:
  explicit PythonScheme(const py::object& object)
      : object_(share(object)),
        name_(read_name(object)),
        summary_(read_text(object, "summary")),
        source_(read_text(object, "source")),
        fails_when_(read_text(object, "fails_when")),
        order_(read_order(object)),
        energy_(read_conservation(object, "energy")),
        angular_momentum_(read_conservation(object, "angular_momentum")),
        rotation_(read_conservation(object, "rotation")),
        takes_rotors_(object.attr("takes_rotors").cast<bool>()) {}

  SchemeDescription description() const noexcept override {
    return {name_,   summary_,          source_,   fails_when_,        order_,
            energy_, angular_momentum_, rotation_, TurnVelocity::mean, takes_rotors_};
  }

  void step(const StepInput& input, RotationState& state) const noexcept override {
    if (has_exception() || !step_in_python(input, state)) {
      state.omega_W.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  const py::object& object() const { return *object_; }

 private:
  bool step_in_python(const StepInput& input, RotationState& state) const noexcept {
    const py::gil_scoped_acquire gil;
    try {
      const py::object end =
          object_->attr("step")(to_array(input.inertia_B), state, input.dt, to_array(input.delta_omega_W));
      if (!py::isinstance<RotationState>(end)) {
        throw py::type_error("step of scheme " + name_ + " must return a polhode.State, returned " +
                             py::repr(end).cast<std::string>());
      }
      state = end.cast<RotationState>();
      require_declared_rotation(state);
      return true;
    } catch (...) {
      keep_exception();
      return false;
    }
  }

  // Bullet's bodies keep q_WB alone, unless the scheme declares that it loses the rotation.
  void require_declared_rotation(const RotationState& state) const {
    constexpr double kRounding = 1e-9;
    if (rotation_ == Conservation::lost || std::abs(state.R_WB.determinant() - 1.0) < kRounding) return;
    throw py::value_error(
        "step of scheme " + name_ + " returned an R_WB of determinant " +
        std::to_string(state.R_WB.determinant()) +
        "; valid is a rotation, or another matrix if the scheme declares rotation = \"lost\"");
  }

  SharedObject object_;
  std::string name_;
  std::string summary_;
  std::string source_;
  std::string fails_when_;
  std::optional<int> order_;
  Conservation energy_;
  Conservation angular_momentum_;
  Conservation rotation_;
  bool takes_rotors_;
};

}  // namespace

SchemePointer make_python_scheme(const py::object& object) {
  return std::make_shared<PythonScheme>(object);
}

py::object python_object(const RotationScheme& scheme) {
  const auto* python = dynamic_cast<const PythonScheme*>(&scheme);
  return python != nullptr ? python->object() : py::none();
}

}  // namespace polhode::python
