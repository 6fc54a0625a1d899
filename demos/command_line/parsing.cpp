#include "command_line/parsing.h"

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "record/output_file.h"
#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

std::string option_names(const CLI::App& app) {
  std::string names;
  for (const CLI::Option* option : app.get_options()) {
    names += (names.empty() ? "" : ", ") + option->get_name(false, true);
  }
  return names;
}

std::string subcommand_names(const CLI::App& app) {
  std::string names;
  for (const CLI::App* subcommand : app.get_subcommands({})) {
    names += (names.empty() ? "" : ", ") + subcommand->get_name();
  }
  return names;
}

std::string valid_words(const CLI::App& app) {
  if (!app.get_subcommands().empty()) return valid_words(*app.get_subcommands().front());
  const std::string subcommands = subcommand_names(app);
  return (subcommands.empty() ? "" : "valid subcommands are " + subcommands + "; ") + "valid options are " +
         option_names(app);
}

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& valid) {
  throw std::invalid_argument(option + ": must be " + valid + ", is \"" + text + "\"");
}

}  // namespace

bool parse(CLI::App& app, int argument_count, char** arguments) {
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& asked_for_help) {
    app.exit(asked_for_help, std::cout, std::cerr);
    return false;
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + "; " + valid_words(app));
  }
  return true;
}

double option_number(const std::string& option, const std::string& text, const Range& range) {
  const std::optional<double> value = parse_number(text);
  if (!value || !range.contains(*value)) refuse(option, text, range_text(range));
  return *value;
}

std::int64_t option_whole_number(const std::string& option, const std::string& text, const Range& range) {
  const std::optional<double> value = parse_number(text);
  if (!value || !range.contains(*value) || *value != std::floor(*value)) {
    refuse(option, text,
           "a whole number between " + number_text(range.lowest) + " and " + number_text(range.highest));
  }
  return static_cast<std::int64_t>(*value);
}

void check_different_files(const std::optional<std::filesystem::path>& csv,
                           const std::optional<std::filesystem::path>& json) {
  if (csv && json && same_file(*csv, *json)) {
    throw std::invalid_argument("--csv and --json: both are " + csv->string() + "; valid are two files");
  }
}

}  // namespace polhode::demos
