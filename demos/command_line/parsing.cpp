#include "command_line/parsing.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "command_line/program.h"
#include "record/output_file.h"
#include "record/scheme_library.h"
#include "scenario/number_text.h"
#include "scenario/printable_text.h"

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

// Writes the word byte by byte, as bash, zsh and a POSIX 2024 shell read it.
std::string escaped_shell_word(const std::string& word) {
  std::string quoted = "$'";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'' || c == '\\') {
      quoted += {'\\', c};
    } else if (byte >= ' ' && byte <= '~') {
      quoted += c;
    } else {
      quoted += '\\';
      for (const int place : {64, 8, 1}) quoted += static_cast<char>('0' + byte / place % 8);
    }
  }
  return quoted + "'";
}

// Quotes a word if a shell would split or expand it, or if a page would not show its characters.
std::string shell_word(const std::string& word) {
  if (!first_unprintable(word).empty()) return escaped_shell_word(word);
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

bool parse(CLI::App& app, int argument_count, char** arguments) {
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& asked_for_help) {
    std::ostringstream text;
    app.exit(asked_for_help, text, text);
    print(text.str());
    return false;
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + "; " + valid_words(app));
  }
  return true;
}

void add_scheme_library_option(CLI::App& app) {
  app.add_option_function<std::vector<std::string>>(
         "--scheme-library",
         [](const std::vector<std::string>& files) {
           for (const std::string& file : files) load_scheme_library(file);
         },
         "Load schemes of your own (polhode/scheme_library.h); repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false);
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

void check_different_files(const std::vector<OutputOption>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = i + 1; j < outputs.size(); ++j) {
      if (!outputs[i].file || !outputs[j].file || !same_file(*outputs[i].file, *outputs[j].file)) continue;
      throw std::invalid_argument(outputs[i].option + " and " + outputs[j].option + ": both are " +
                                  outputs[i].file->string() + "; valid are two files");
    }
  }
}

std::string command_line(int argument_count, char** arguments) {
  std::string line;
  for (int i = 0; i < argument_count; ++i) {
    const std::string word = i == 0 ? std::filesystem::path(arguments[0]).filename().string() : arguments[i];
    line += (i == 0 ? "" : " ") + shell_word(word);
  }
  return line;
}

}  // namespace polhode::demos
