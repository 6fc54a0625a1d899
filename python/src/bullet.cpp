// polhode._float64 and polhode._float32: what runs in Bullet, in one of its precisions.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "command_line/interruption.h"
#include "compare/side_by_side.h"
#include "polhode/scheme_registry.h"
#include "python_scheme.h"
#include "record/comparison_json.h"
#include "record/table.h"
#include "scenario/scenario_reader.h"
#include "signal_check.h"
#include "trajectory.h"
#include "workprecision/curve.h"
#include "workprecision/curve_text.h"
#include "world/body_shape.h"
#include "world/run.h"

namespace polhode::python {

namespace {

// A scenario as Python holds it.
struct ScenarioText {
  std::string json;
  std::string file_name;  // for messages
};

demos::Scenario read(const ScenarioText& scenario) {
  return demos::parse_scenario(scenario.json, scenario.file_name);
}

// Names and schemes; None: the default ones.
using ContenderList = std::optional<std::vector<std::variant<std::string, SchemeHandle>>>;

demos::Contender contender_of(const std::variant<std::string, SchemeHandle>& chosen) {
  if (const std::string* name = std::get_if<std::string>(&chosen))
    return demos::find_contenders({*name}).front();
  const SchemePointer& scheme = std::get<SchemeHandle>(chosen).scheme;
  const SchemeDescription description = scheme->description();
  return {std::string(description.name), std::string(description.summary), scheme};
}

std::vector<demos::Contender> contenders_of(const ContenderList& list) {
  std::vector<demos::Contender> contenders;
  for (const auto& chosen : *list) {
    demos::Contender contender = contender_of(chosen);
    for (const demos::Contender& other : contenders) {
      if (other.name == contender.name) {
        throw std::invalid_argument("contender \"" + contender.name +
                                    "\" is given twice; valid is each once");
      }
    }
    contenders.push_back(std::move(contender));
  }
  if (contenders.empty()) throw std::invalid_argument("contenders is empty; valid is at least one");
  return contenders;
}

demos::ChosenContenders chosen_for(const demos::Scenario& scenario, const ContenderList& list) {
  if (!list) return demos::chosen_contenders({}, scenario);
  demos::ChosenContenders chosen{contenders_of(list), ""};
  for (const demos::Contender& contender : chosen.contenders) demos::require_can_run(contender, scenario);
  return chosen;
}

// A finished comparison.
struct Result {
  demos::Report report;
  py::dict series;
};

// `every`: of the series, 0 for at most 10,000 records.
Result compare(const ScenarioText& text, const ContenderList& list, std::int64_t every,
               const py::function& check) {
  const demos::Scenario scenario = read(text);
  const demos::ChosenContenders chosen = chosen_for(scenario, list);
  constexpr std::int64_t kMostRecords = 10'000;
  const std::int64_t steps = demos::step_count(scenario.dt, scenario.duration);
  if (every == 0) every = (steps + kMostRecords - 1) / kMostRecords;
  std::vector<Trajectory> series(chosen.contenders.size(), Trajectory(every));
  Result result;
  {
    SignalCheck look_in(check);
    const py::gil_scoped_release no_gil;
    result.report = demos::run_side_by_side(scenario, chosen, "polhode.compare",
                                            [&](std::size_t contender, const demos::Sample& sample) {
                                              look_in();
                                              series[contender].add(sample);
                                            });
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    result.series[py::str(chosen.contenders[i].name)] = series[i].finish();
  }
  return result;
}

// The table and the JSON text.
py::tuple work_precision(const ScenarioText& scenario, const ContenderList& list, double time_s,
                         double dt_from, std::int64_t levels, std::int64_t rounds,
                         const py::function& check) {
  demos::CurveOptions options;
  options.body = demos::free_body(read(scenario));
  options.contenders = list ? contenders_of(list) : demos::all_contenders();
  options.time_s = time_s;
  options.dt_from_s = dt_from;
  options.levels = levels;
  options.rounds = rounds;
  SignalCheck look_in(check);
  std::string table;
  std::string json;
  {
    const py::gil_scoped_release no_gil;
    const demos::InterruptionCheck interruption(std::ref(look_in));
    const demos::Curve curve = demos::measure_curve(options, [](std::int64_t, const std::string&) {});
    table = demos::curve_table(curve);
    json = demos::curve_json(curve);
  }
  return py::make_tuple(table, json);
}

py::dict contender_summaries() {
  py::dict summaries;
  for (const demos::Contender& contender : demos::all_contenders()) {
    summaries[py::str(contender.name)] = contender.summary;
  }
  return summaries;
}

}  // namespace

}  // namespace polhode::python

PYBIND11_MODULE(POLHODE_PYTHON_MODULE, module) {
  using namespace polhode::python;
  py::module_::import("polhode._core");  // SchemeHandle
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const polhode::demos::ScenarioError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
  py::class_<ScenarioText>(module, "ScenarioText", py::module_local())
      .def(py::init([](std::string json, std::string file_name) {
        return ScenarioText{std::move(json), std::move(file_name)};
      }));
  py::class_<Result>(module, "Result", py::module_local())
      .def_readonly("series", &Result::series)
      .def("table",
           [](const Result& result) { return polhode::demos::comparison_table(result.report.comparison); })
      .def("json",
           [](const Result& result) { return polhode::demos::comparison_json(result.report.comparison); })
      .def("html", [](const Result& result) { return polhode::demos::report_html(result.report); });
  module.def("compare", &compare, py::arg("scenario"), py::arg("contenders"), py::arg("every"),
             py::arg("check"));
  module.def("work_precision", &work_precision, py::arg("scenario"), py::arg("contenders"), py::arg("time_s"),
             py::arg("dt_from"), py::arg("levels"), py::arg("rounds"), py::arg("check"));
  module.def("contenders", &contender_summaries);
  module.def("register_scheme", [](const SchemeHandle& handle) { polhode::register_scheme(handle.scheme); });
}
