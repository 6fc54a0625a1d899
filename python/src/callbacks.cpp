#include "callbacks.h"

#include <utility>

namespace polhode::python {

namespace {

// A pointer, so that the end of a thread, which does not hold the GIL, destroys nothing of Python's.
thread_local py::error_already_set* kept = nullptr;

}  // namespace

SharedObject share(py::object object) {
  return {new py::object(std::move(object)), [](const py::object* shared) {
            const py::gil_scoped_acquire gil;
            delete shared;
          }};
}

void keep_exception() {
  if (kept != nullptr) return;
  try {
    throw;
  } catch (py::error_already_set& error) {
    kept = new py::error_already_set(std::move(error));
  } catch (const py::builtin_exception& error) {
    error.set_error();
    kept = new py::error_already_set();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
    kept = new py::error_already_set();
  }
}

bool has_exception() {
  return kept != nullptr;
}

void raise_kept_exception() {
  if (kept == nullptr) return;
  const std::unique_ptr<py::error_already_set> error(std::exchange(kept, nullptr));
  throw py::error_already_set(std::move(*error));
}

}  // namespace polhode::python
