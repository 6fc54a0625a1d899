#include "viewer/model/options.h"

#include <cmath>
#include <stdexcept>

#include "command_line/parsing.h"
#include "scenario/build_info.h"
#include "scenario/named_error.h"
#include "scenario/number_text.h"
#include "scenario/scenario_directory.h"
#include "viewer/model/playback_clock.h"
#include "world/body_shape.h"

namespace polhode::demos {

namespace {

constexpr Range kTimeRange{0.0, 1e9};
constexpr double kMostStepsToWaitFor = 1e6;
constexpr Range kSizeRange{200, 8192};
constexpr Range kSpeedRange{PlaybackClock::kSlowest, PlaybackClock::kFastest};

struct NumberTexts {
  std::optional<std::string> dt;
  std::optional<std::string> at;
  std::optional<std::string> speed;
  std::optional<std::string> width;
  std::optional<std::string> height;
};

void add_options(CLI::App& app, ViewerOptions& options, NumberTexts& texts) {
  app.set_version_flag("--version", std::string("polhode ") + kVersion);
  app.add_option("--scenario", options.scenario, "A name from polhode_compare --list, or a .json file")
      ->type_name("NAME|FILE.json")
      ->capture_default_str();
  app.add_option("--contender", options.contenders,
                 "A name from polhode_compare --list; repeatable (default: as in polhode_compare)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_scheme_library_option(app);
  app.add_option("--dt", texts.dt, "Length of a step, instead of the scenario's")->type_name("SECONDS");
  app.add_option("--speed", texts.speed, "Simulated time per real time (default: 1)")->type_name("FACTOR");
  app.add_option("--at", texts.at, "Open at this time (default: 0)")->type_name("SECONDS");
  app.add_option("--screenshot", options.screenshot,
                 "Write a picture to this file, without a display, and exit")
      ->type_name("FILE.png");
  app.add_option("--record", options.record, "Write the run to this file when the viewer is closed")
      ->type_name("FILE");
  app.add_option("--replay", options.replay, "Run a recording again and compare every bit")
      ->type_name("FILE")
      ->excludes("--scenario")
      ->excludes("--contender")
      ->excludes("--dt");
  app.add_flag("--through-window", options.through_window,
               "Take the screenshot in a hidden window of the display");
  app.add_option("--width", texts.width, "Width of window and screenshot (default: 1600)")
      ->type_name("PIXELS");
  app.add_option("--height", texts.height, "Height of window and screenshot (default: 1000)")
      ->type_name("PIXELS");
  app.add_flag("--teaching", options.is_teaching, "Open with inertia ellipsoid, polhode and herpolhode");
  app.add_flag("--no-panels", options.has_no_panels, "Open without controls and plots");
}

template <typename Number>
void set_whole_number(Number& number, const std::string& option, const std::optional<std::string>& text,
                      const Range& range) {
  if (text) number = static_cast<Number>(option_whole_number(option, *text, range));
}

void set_numbers(ViewerOptions& options, const NumberTexts& texts) {
  if (texts.dt) options.dt = option_number("--dt", *texts.dt, kDtRange);
  if (texts.at) options.at_s = option_number("--at", *texts.at, kTimeRange);
  if (texts.speed) options.speed = option_number("--speed", *texts.speed, kSpeedRange);
  set_whole_number(options.width, "--width", texts.width, kSizeRange);
  set_whole_number(options.height, "--height", texts.height, kSizeRange);
}

Scenario chosen_scenario(const ViewerOptions& options) {
  Scenario scenario = find_scenario(options.scenario);
  scenario.dt = options.dt.value_or(scenario.dt);
  return naming_the_scenario(options.scenario, [&] { return resolved(scenario); });
}

}  // namespace

std::optional<ViewerOptions> parse_viewer_options(int argument_count, char** arguments) {
  ViewerOptions options;
  NumberTexts texts;
  CLI::App app("Shows one scenario, rotated by several contenders side by side.");
  add_options(app, options, texts);
  if (!parse(app, argument_count, arguments)) return std::nullopt;
  set_numbers(options, texts);
  if (options.through_window && !options.screenshot) {
    throw std::invalid_argument("--through-window: valid only with --screenshot FILE.png");
  }
  return options;
}

Session chosen_session(const ViewerOptions& options) {
  if (options.replay) return Session(read_recording(*options.replay));
  const Scenario scenario = chosen_scenario(options);
  const ChosenContenders chosen = chosen_contenders(options.contenders, scenario);
  Session session(scenario, chosen.contenders);
  session.set_notice(chosen.note);
  return session;
}

std::int64_t chosen_step(const ViewerOptions& options, const Session& session) {
  if (options.replay && options.screenshot && !options.at_s) return session.replayed_steps();
  const double dt = session.simulation().scenario().dt;
  const double steps = std::round(options.at_s.value_or(0.0) / dt);
  if (steps > kMostStepsToWaitFor) {
    throw std::invalid_argument("--at: is " + number_text(*options.at_s) + " s, more than " +
                                number_text(kMostStepsToWaitFor) + " steps of " + number_text(dt) +
                                " s; valid is up to " + number_text(kMostStepsToWaitFor * dt) + " s");
  }
  return static_cast<std::int64_t>(steps);
}

}  // namespace polhode::demos
