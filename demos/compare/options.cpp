#include "compare/options.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "record/output_file.h"
#include "scenario/build_info.h"
#include "scenario/number_text.h"
#include "scenario/scenario.h"

namespace polhode::demos {

namespace {

// Not left to CLI11, which reads numbers as the locale writes them.
std::optional<double> seconds(const std::string& option, const std::optional<std::string>& text,
                              const Range& range) {
  if (!text) return std::nullopt;
  const std::optional<double> value = parse_number(*text);
  if (!value || !range.contains(*value)) {
    throw std::invalid_argument(option + ": must be " + range_text(range) + ", is \"" + *text + "\"");
  }
  return value;
}

std::string option_names(const CLI::App& app) {
  std::string names;
  for (const CLI::Option* option : app.get_options()) {
    names += (names.empty() ? "" : ", ") + option->get_name(false, true);
  }
  return names;
}

void check_files(const Options& options) {
  if (options.csv && options.json && same_file(*options.csv, *options.json)) {
    throw std::invalid_argument("--csv and --json: both are " + options.csv->string() +
                                "; valid are two files");
  }
}

// False: --help or --version was asked for, and printed.
bool parse(CLI::App& app, int argument_count, char** arguments) {
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& asked_for_help) {
    app.exit(asked_for_help, std::cout, std::cerr);
    return false;
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + "; valid options are " + option_names(app));
  }
  return true;
}

}  // namespace

std::optional<Options> parse_options(int argument_count, char** arguments) {
  Options options;
  std::optional<std::string> dt;
  std::optional<std::string> duration;
  CLI::App app("Rotates one scenario by several contenders, side by side.");
  app.set_version_flag("--version", std::string("polhode ") + kVersion);
  app.add_flag("--list", options.list, "List scenarios and contenders");
  app.add_option("--scenario", options.scenario, "A name from --list, or a .json file")
      ->type_name("NAME|FILE.json")
      ->capture_default_str();
  app.add_option("--contender", options.contenders,
                 "A name from --list; repeatable (default: the handout's, Bullet's)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--dt", dt, "Length of a step, in place of the scenario's")->type_name("SECONDS");
  app.add_option("--duration", duration, "Length of the run, in place of the scenario's")
      ->type_name("SECONDS");
  app.add_option("--csv", options.csv, "Write every step there")->type_name("FILE");
  app.add_option("--json", options.json, "Write the table's figures there")->type_name("FILE");
  if (!parse(app, argument_count, arguments)) return std::nullopt;
  options.dt = seconds("--dt", dt, kDtRange);
  options.duration = seconds("--duration", duration, kDurationRange);
  check_files(options);
  return options;
}

}  // namespace polhode::demos
