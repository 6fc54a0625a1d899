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
    "Runs a program that links Bullet dynamically, with its bodies rotated by Polhode. The program is not "
    "compiled\n"
    "anew: each world that it steps gets a polhode::RotationPlugin. Exit code and signals are the program's.";

constexpr char kFooter[] =
    "Options stand before PROGRAM; what follows it is the program's. Processes that the program starts are "
    "rotated\n"
    "too, and each that steps a world writes a summary. A process writes it as it exits: none is written if "
    "a signal\n"
    "ends it, or _exit().\n"
    "\n"
    "Exit codes of its own: 2 for a bad option or a program that cannot be rotated, 126 for a program that "
    "cannot\n"
    "be executed, 127 for one that is not found.\n"
    "\n"
    "Left to Bullet, with a line on standard error: worlds that a plugin cannot be attached to (deformable "
    "and simple\n"
    "ones, those with an island manager of their own), worlds that the program itself rotates by Polhode, "
    "and those\n"
    "of another Bullet than the one this polhode-run was built for. Not seen: Bullet that is linked "
    "statically.";

class WithProgram : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override {
    return "Usage: polhode-run [OPTIONS] PROGRAM [ARGUMENTS...]\n";
  }
};

// CLI11 takes the first word that is no option of ours for the program, also a mistyped option.
std::vector<std::string> program_of(const CLI::App& app) {
  std::vector<std::string> words = app.remaining();
  const bool is_marked = !words.empty() && words.front() == "--";
  if (is_marked) words.erase(words.begin());
  if (words.empty()) throw std::invalid_argument("PROGRAM: missing; polhode-run --help shows how to call it");
  if (!is_marked && words.front()[0] == '-') {
    throw std::invalid_argument(
        words.front() +
        ": unknown option; valid options are --help, --version, --scheme, --summary, --quiet");
  }
  return words;
}

// The program may change its folder before it ends.
std::string absolute_summary(const std::string& summary) {
  if (summary.empty()) throw std::invalid_argument("--summary: must be a file or -, is \"\"");
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
                 "What rotates the bodies, see below (default: " + options.scheme + ")")
      ->type_name("NAME");
  app.add_option("--summary", options.summary, "Write the summary there (default: -, standard error)")
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
