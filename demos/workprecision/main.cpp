// Compares errors, costs and limits of stability of the schemes and of Bullet's modes. Built for each of
// Bullet's precisions.
#include <iostream>
#include <streambuf>

#include "command_line/interruption.h"
#include "command_line/program.h"
#include "workprecision/cost.h"
#include "workprecision/curve.h"
#include "workprecision/curve_text.h"
#include "workprecision/map.h"
#include "workprecision/ranks.h"

namespace {

using namespace polhode::demos;

/// Discards the output of all ranks but the first.
class SilentOutput : public std::streambuf {
 public:
  explicit SilentOutput(bool silent) : before_(silent ? std::cout.rdbuf(this) : nullptr) {}
  ~SilentOutput() override {
    if (before_ != nullptr) std::cout.rdbuf(before_);
  }

 protected:
  int overflow(int character) override { return traits_type::not_eof(character); }

 private:
  std::streambuf* before_;
};

void work(int argument_count, char** arguments, Ranks& ranks) {
  std::optional<WorkPrecisionOptions> options;
  ranks.together([&] { options = parse_work_precision_options(argument_count, arguments); });
  if (!options) return;
  watch_for_interruption();
  if (const MapOptions* map = std::get_if<MapOptions>(&*options)) return make_map(map->grid, map->run, ranks);
  if (const JointsOptions* joints = std::get_if<JointsOptions>(&*options)) {
    return make_map(joints->grid, joints->run, ranks);
  }
  // The remaining commands measure one core; more ranks would disturb them.
  if (!ranks.is_first()) return;
  if (const CostOptions* cost = std::get_if<CostOptions>(&*options)) return print(cost_table(costs(*cost)));
  print(curve_table(curve(std::get<CurveOptions>(*options))));
}

}  // namespace

int main(int argument_count, char** arguments) {
  Ranks ranks(argument_count, arguments);
  const SilentOutput silence(!ranks.is_first());
  const int exit_code = run_program(
      argument_count > 0 ? arguments[0] : "polhode_workprecision",
      [&] { work(argument_count, arguments, ranks); },
      [&] { return ranks.stopped_together() && !ranks.is_first(); });
  // The other ranks may be waiting for this one.
  if (exit_code != 0 && !ranks.stopped_together()) ranks.end_all(exit_code);
  return exit_code;
}
