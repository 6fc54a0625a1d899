#include "bindings.h"
#include "callbacks.h"
#include "polhode/version.h"

PYBIND11_MODULE(_core, module) {
  using namespace polhode::python;
  module.attr("version") = polhode::version();
  module.def("raise_kept_exception", &raise_kept_exception);
  bind_state(module);
  bind_schemes(module);
  bind_torque_laws(module);
  bind_free_motion(module);
  bind_scenario(module);
}
