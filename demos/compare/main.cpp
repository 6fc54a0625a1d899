// Rotates one scenario by several contenders and prints how well each keeps energy, momentum and orientation.
// Built for each of Bullet's precisions.
#include "command_line/interruption.h"
#include "command_line/program.h"
#include "compare/comparison.h"
#include "record/table.h"

int main(int argument_count, char** arguments) {
  using namespace polhode::demos;
  return run_program(argument_count > 0 ? arguments[0] : "polhode_compare", [&] {
    const std::optional<Options> options = parse_options(argument_count, arguments);
    if (!options) return;
    watch_for_interruption();
    print(options->list ? list_text() : comparison_table(compare(*options)));
  });
}
