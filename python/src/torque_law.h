#pragma once

#include <pybind11/pybind11.h>

#include "polhode/torque_law.h"

namespace polhode::python {

namespace py = pybind11;

/// A law of C++'s as Python holds it.
struct LawHandle {
  TorqueLaw law;
};

/// Reads a law: one of C++'s, a callable of a motion, or None for an empty one.
/// @throws TypeError
TorqueLaw read_law(const py::object& law);

}  // namespace polhode::python
