#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record/contender.h"
#include "scenario/scenario.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Holds the options of polhode_viewer's command line.
struct ViewerOptions {
  std::string scenario = "dzhanibekov";
  std::vector<std::string> contenders;  ///< empty for the default ones
  std::optional<double> dt;
  std::optional<double> at_s;
  double speed = 1.0;
  int width = 1600;
  int height = 1000;
  bool is_teaching = false;
  bool has_no_panels = false;
  bool through_window = false;  ///< of the screenshot
  std::optional<std::filesystem::path> screenshot;
  std::optional<std::filesystem::path> record;
  std::optional<std::filesystem::path> replay;
};

/// Returns the options, or nothing if the command line asked for --help or --version, which is then printed.
/// @throws std::invalid_argument that says what is wrong and what is valid
std::optional<ViewerOptions> parse_viewer_options(int argument_count, char** arguments);

/// Starts the session that the options choose: a scenario with contenders, or a recording.
/// @throws std::invalid_argument, ScenarioError
Session chosen_session(const ViewerOptions& options);
/// Returns the step that --at selects. Without --at returns the start, or the end for a screenshot of a
/// replay.
/// @throws std::invalid_argument if the step is too far from the start
std::int64_t chosen_step(const ViewerOptions& options, const Session& session);

}  // namespace polhode::demos
