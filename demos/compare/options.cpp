#include "compare/options.h"

#include "command_line/parsing.h"
#include "scenario/build_info.h"
#include "scenario/scenario.h"

namespace polhode::demos {

namespace {

std::optional<double> seconds(const std::string& option, const std::optional<std::string>& text,
                              const Range& range) {
  if (!text) return std::nullopt;
  return option_number(option, *text, range);
}

}  // namespace

std::optional<Options> parse_options(int argument_count, char** arguments) {
  Options options;
  std::optional<std::string> dt;
  std::optional<std::string> duration;
  CLI::App app("Runs one scenario with several contenders side by side.");
  app.set_version_flag("--version", std::string("polhode ") + kVersion);
  app.add_flag("--list", options.list, "List scenarios and contenders");
  app.add_option("--scenario", options.scenario, "A name from --list, or a .json file")
      ->type_name("NAME|FILE.json")
      ->capture_default_str();
  app.add_option("--contender", options.contenders,
                 "A name from --list; repeatable (default: exact, the handout's schemes, those of scheme "
                 "libraries, Bullet's modes)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_scheme_library_option(app);
  app.add_option("--dt", dt, "Length of a step, instead of the scenario's")->type_name("SECONDS");
  app.add_option("--duration", duration, "Length of the run, instead of the scenario's")
      ->type_name("SECONDS");
  app.add_option("--csv", options.csv, "Write every step to this file")->type_name("FILE");
  app.add_option("--json", options.json, "Write the table's figures to this file")->type_name("FILE");
  app.add_option("--report", options.report, "Write a page with plots and 3D playback to this file")
      ->type_name("FILE.html");
  if (!parse(app, argument_count, arguments)) return std::nullopt;
  options.dt = seconds("--dt", dt, kDtRange);
  options.duration = seconds("--duration", duration, kDurationRange);
  check_different_files({{"--csv", options.csv}, {"--json", options.json}, {"--report", options.report}});
  options.command = command_line(argument_count, arguments);
  return options;
}

}  // namespace polhode::demos
