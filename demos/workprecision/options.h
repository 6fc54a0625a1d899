#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "workprecision/joints/joints_grid.h"
#include "workprecision/kernel.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {

/// The files that a command writes besides stdout.
struct Outputs {
  std::optional<std::filesystem::path> csv;
  std::optional<std::filesystem::path> json;
};

/// Options of `curve`: error against cost for a series of time steps.
struct CurveOptions {
  FreeBody body;
  std::optional<std::string> scenario;  ///< replaces `body`
  std::vector<Contender> contenders;
  double time_s = 10.0;
  double dt_from_s = 1.0 / 15.0;
  std::int64_t levels = 8;
  std::int64_t rounds = 21;
  Outputs outputs;
};

struct CostOptions {
  FreeBody body;
  std::vector<Contender> contenders;
  double dt_s = 1.0 / 60.0;
  std::int64_t rounds = 201;
  Outputs outputs;
};

/// How a map is computed and where it is written. The cells do not depend on this.
struct MapRun {
  std::int64_t threads = 0;  ///< 0: one per core, or one with MPI
  bool restart = false;
  Outputs outputs;
};

struct MapOptions {
  MapGrid grid;
  MapRun run;
};

struct JointsOptions {
  JointsGrid grid;
  MapRun run;
};

using WorkPrecisionOptions = std::variant<CurveOptions, CostOptions, MapOptions, JointsOptions>;

/// Returns the options, or nothing if the command line asked for --help or --version, which is then printed.
/// @throws std::invalid_argument that says what is wrong and what is valid
std::optional<WorkPrecisionOptions> parse_work_precision_options(int argument_count, char** arguments);

}  // namespace polhode::demos
