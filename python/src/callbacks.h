#pragma once

#include <pybind11/pybind11.h>

#include <memory>

/// What C++ needs to call Python from a run that has released the GIL.
namespace polhode::python {

namespace py = pybind11;

/// Shares a Python object with code that does not hold the GIL.
using SharedObject = std::shared_ptr<const py::object>;
SharedObject share(py::object object);

/// Keeps the Python exception that is being handled as this thread's, unless the thread has one already. A
/// scheme's step and a torque law may not throw through the core. Call with the GIL, in a catch block.
void keep_exception();

/// Returns true if this thread has kept an exception. Its run is at an end then, and calls Python no more.
bool has_exception();

/// Throws the kept exception, if there is one. Call with the GIL, at the end of each run.
void raise_kept_exception();

}  // namespace polhode::python
