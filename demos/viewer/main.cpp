// Shows a scenario, rotated by several contenders side by side, in a window or as a picture.
#include <algorithm>

#include "command_line/interruption.h"
#include "command_line/program.h"
#include "viewer/interface/live_window.h"
#include "viewer/interface/screenshot.h"

namespace {

using namespace polhode::demos;

/// Checks for Ctrl-C, since a million steps take long.
void run_to(Session& session, std::int64_t step) {
  constexpr std::int64_t kStepsAtOnce = 1000;
  while (session.simulation().shown_step() < step) {
    throw_if_interrupted();
    session.run_to(std::min(step, session.simulation().shown_step() + kStepsAtOnce));
  }
}

void view(const ViewerOptions& options) {
  Session session = chosen_session(options);
  session.clock().set_speed(options.speed);
  run_to(session, chosen_step(options, session));
  if (options.screenshot) {
    write_png(take_screenshot(session, options), *options.screenshot);
  } else {
    show_window(session, options);
  }
  if (options.record) write_recording(session.simulation(), *options.record);
}

}  // namespace

int main(int argument_count, char** arguments) {
  return run_program(argument_count > 0 ? arguments[0] : "polhode_viewer", [&] {
    const std::optional<ViewerOptions> options = parse_viewer_options(argument_count, arguments);
    if (!options) return;
    watch_for_interruption();
    view(*options);
  });
}
