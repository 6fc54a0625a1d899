// Runs a program whose Bullet worlds are rotated by the library.
#include "command_line/program.h"
#include "run/launcher/launch.h"

int main(int argument_count, char** arguments) {
  using namespace polhode;
  int exit_code = 0;
  const int result = demos::run_program(argument_count > 0 ? arguments[0] : "polhode-run", [&] {
    const std::optional<run::Options> options = run::parse_options(argument_count, arguments);
    if (!options) return;
    try {
      run::launch(*options);
    } catch (const run::StartFailure& failure) {
      exit_code = failure.exit_code();
      throw;
    }
  });
  return exit_code != 0 ? exit_code : result;
}
