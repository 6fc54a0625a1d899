#pragma once

#include "callbacks.h"
#include "polhode/scheme_registry.h"

namespace polhode::python {

/// A scheme as Python's modules hand it to each other.
struct SchemeHandle {
  SchemePointer scheme;
};

/// Makes a scheme of a Python object with the attributes of SchemeDescription and a method
/// step(inertia_B, state, dt, delta_omega_W) -> State. An exception in the method is kept (callbacks.h) and
/// leaves a state that is not finite, so that the run ends.
/// @throws TypeError or ValueError for attributes that describe no scheme
SchemePointer make_python_scheme(const py::object& object);

/// Returns the Python object that a scheme was made of, None for one of C++'s.
py::object python_object(const RotationScheme& scheme);

}  // namespace polhode::python
