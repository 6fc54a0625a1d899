#pragma once

#include <pybind11/pybind11.h>

/// The parts of the module polhode._core, which knows no Bullet.
namespace polhode::python {

void bind_state(pybind11::module_& module);
void bind_schemes(pybind11::module_& module);
void bind_torque_laws(pybind11::module_& module);
void bind_free_motion(pybind11::module_& module);
void bind_scenario(pybind11::module_& module);

}  // namespace polhode::python
