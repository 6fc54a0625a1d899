#include "run/launcher/options.h"

#include <memory>
#include <stdexcept>

#include "command_line/parsing.h"
#include "polhode/scheme_registry.h"
#include "run/settings.h"
#include "scenario/build_info.h"

namespace polhode::run {

namespace {

constexpr char kDescription[] =
    R"(Runs a program that links Bullet dynamically, and rotates its bodies by Polhode. The program is not
recompiled: each world that it steps gets a polhode::RotationPlugin. Exit code and signals are those of the
program.)";

constexpr char kFooter[] =
    R"(Put options before PROGRAM; the words after it are the program's arguments. Processes that the program
starts are rotated too, and each one that steps a world writes a summary when it exits. A process that is
ended by a signal or by _exit() writes none.

polhode-run's own exit codes: 2 for an invalid option or a program that cannot be rotated, 126 for a program
that cannot be executed, 127 for one that is not found.

These worlds are left to Bullet, with a line on standard error: worlds to which a plugin cannot be attached
(deformable and simple worlds, worlds with a custom island manager), worlds that the program itself rotates by
Polhode, and worlds of another Bullet than the one for which this polhode-run was built. A statically linked
Bullet is not detected.)";

class WithProgram : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override {
    return "Usage: polhode-run [OPTIONS] PROGRAM [ARGUMENTS...]\n";
  }
};

// CLI11 treats the first word that is not an option of ours as the program, even if it is a mistyped option.
std::vector<std::string> program_of(const CLI::App& app) {
  std::vector<std::string> words = app.remaining();
  const bool is_marked = !words.empty() && words.front() == "--";
  if (is_marked) words.erase(words.begin());
  if (words.empty()) throw std::invalid_argument("PROGRAM: missing; see polhode-run --help");
  if (!is_marked && words.front()[0] == '-') {
    throw std::invalid_argument(
        words.front() +
        ": unknown option; valid options are --help, --version, --scheme, --summary, --quiet");
  }
  return words;
}

// Absolute, since the program may change its working directory.
std::string absolute_summary(const std::string& summary) {
  if (summary.empty()) throw std::invalid_argument("--summary: is \"\": valid are a file and -");
  return summary == kToStandardError ? summary : std::filesystem::absolute(summary).string();
}

}  // namespace

std::optional<Options> parse_options(int argument_count, char** arguments) {
  Options options;
  options.scheme = default_scheme()->description().name;
  options.summary = kToStandardError;
  bool is_quiet = false;
  CLI::App app(kDescription);
  app.formatter(std::make_shared<WithProgram>());
  app.footer("Schemes: " + scheme_names() + "\n\n" + kFooter);
  app.prefix_command();
  app.set_version_flag("--version", std::string("polhode ") + demos::kVersion);
  app.add_option("--scheme", options.scheme,
                 "Scheme that rotates the bodies, see below (default: " + options.scheme + ")")
      ->type_name("NAME");
  app.add_option("--summary", options.summary, "Write the summary to this file (default: -, standard error)")
      ->type_name("FILE|-");
  app.add_flag("--quiet", is_quiet, "Write no summary");
  if (!demos::parse(app, argument_count, arguments)) return std::nullopt;
  try {
    find_scheme(options.scheme);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--scheme: ") + error.what());
  }
  options.summary = is_quiet ? "" : absolute_summary(options.summary);
  options.program = program_of(app);
  return options;
}

}  // namespace polhode::run
