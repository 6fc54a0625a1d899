#include "bindings.h"
#include "scenario/scenario_reader.h"
#include "scenario/scenario_writer.h"

namespace polhode::python {

void bind_scenario(pybind11::module_& module) {
  module.def(
      "complete_scenario",
      [](const std::string& text, const std::string& file_name) {
        try {
          return demos::scenario_json(demos::parse_scenario(text, file_name)).dump();
        } catch (const demos::ScenarioError& error) {
          throw pybind11::value_error(error.what());
        }
      },
      pybind11::arg("text"), pybind11::arg("file_name"));
}

}  // namespace polhode::python
