#include "workprecision/options.h"

#include <functional>
#include <map>
#include <stdexcept>

#include "command_line/parsing.h"
#include "scenario/build_info.h"
#include "scenario/scenario.h"

namespace polhode::demos {

namespace {

constexpr Range kSpeedRange{-1e6, 1e6};
constexpr Range kLevelRange{1, 30};
constexpr Range kRoundRange{1, 1e6};
constexpr Range kOmegaDtRange{1e-6, 1e3};
constexpr Range kRatioRange{1.0, 1e6};
constexpr Range kJointOmegaDtRange{1e-4, 3.1};  // below half a turn, which has no direction
constexpr Range kTiltRange{0.0, 3.1415926535897931};
constexpr Range kJointDtRange{1e-5, 0.5};
constexpr Range kJointTimeRange{2.0, 1000.0};
constexpr Range kCountRange{1, 10000};
constexpr Range kStepsRange{1, kMostSteps};
constexpr Range kThreadRange{1, 1024};

using Texts = std::vector<std::string>;

/// The options of one subcommand. CLI11 collects the texts; `read` converts them to values afterwards.
class Subcommand {
 public:
  Subcommand(CLI::App& app, const std::string& name, const std::string& summary)
      : app_(*app.add_subcommand(name, summary)) {
    add_scheme_library_option(app_);
  }

  CLI::App& app() { return app_; }
  bool chosen() const { return app_.parsed(); }

  void number(const std::string& name, const std::string& help, const Range& range, double& value) {
    one_text(name, "NUMBER", help,
             [=, &value](const std::string& text) { value = option_number(name, text, range); });
  }

  void whole_number(const std::string& name, const std::string& help, const Range& range,
                    std::int64_t& value) {
    one_text(name, "N", help,
             [=, &value](const std::string& text) { value = option_whole_number(name, text, range); });
  }

  void vector(const std::string& name, const std::string& help, const Range& range, Vector3& value) {
    add(name, "NUMBER", help, [=, &value](const Texts& texts) {
      for (int i = 0; i < 3; ++i) value[i] = option_number(name, texts[static_cast<std::size_t>(i)], range);
    })->expected(3);
  }

  template <class Axis>
  void axis(const std::string& name, const std::string& help, const Range& range, Axis& axis) {
    add(name, "NUMBER", help, [=, &axis](const Texts& texts) {
      axis.from = option_number(name, texts[0], range);
      axis.to = option_number(name, texts[1], range);
      axis.count = option_whole_number(name, texts[2], kCountRange);
      if (axis.from >= axis.to) throw std::invalid_argument(name + ": valid is FROM less than TO");
    })->expected(3);
  }

  void contenders(const std::string& names, std::vector<Contender>& value) {
    add(names, "NAME", "A scheme or a mode of Bullet; repeatable (default: all)",
        [&value](const Texts& texts) { value = find_contenders(texts); })
        ->allow_extra_args(false);
    checks_.emplace_back([&value] {
      if (value.empty()) value = all_contenders();  // scheme libraries are loaded by now
    });
  }

  void schemes(std::vector<Contender>& value) {
    add("--scheme", "NAME", "A scheme; repeatable (default: exact). Bullet's modes always run",
        [&value](const Texts& texts) { value = schemes_and_bullet(texts); })
        ->allow_extra_args(false);
  }

  void kinds(std::vector<JointKind>& value) {
    add("--kind", "NAME", "hinge, motor, weld, point, lock or spring; repeatable (default: all)",
        [&value](const Texts& texts) { value = find_joint_kinds(texts); })
        ->allow_extra_args(false);
  }

  void start(SpinStart& value) {
    one_text("--start", "middle_axis|generic", "How the spin starts (default: middle_axis)",
             [&value](const std::string& text) {
               if (text != "generic" && text != "middle_axis") {
                 throw std::invalid_argument("--start: is \"" + text + "\"; valid are middle_axis, generic");
               }
               value = text == "generic" ? SpinStart::generic : SpinStart::middle_axis;
             });
  }

  void outputs(const std::string& what, Outputs& outputs) {
    app_.add_option("--csv", outputs.csv, "Write " + what + " to this file")->type_name("FILE");
    app_.add_option("--json", outputs.json, "Write " + what + " to this file")->type_name("FILE");
    checks_.emplace_back([&outputs] {
      check_different_files({{"--csv", outputs.csv}, {"--json", outputs.json}});
    });
  }

  void read() {
    for (const std::function<void()>& check : checks_) check();
  }

 private:
  CLI::Option* add(const std::string& name, const std::string& type, const std::string& help,
                   const std::function<void(const Texts&)>& take) {
    Texts& texts = texts_[name];
    CLI::Option* option = app_.add_option(name, texts, help)->type_name(type);
    checks_.emplace_back([&texts, take] {
      if (!texts.empty()) take(texts);
    });
    return option;
  }

  void one_text(const std::string& name, const std::string& type, const std::string& help,
                const std::function<void(const std::string&)>& take) {
    add(name, type, help, [take](const Texts& texts) { take(texts.front()); })->expected(1);
  }

  CLI::App& app_;
  std::map<std::string, Texts> texts_;
  std::vector<std::function<void()>> checks_;
};

void declare_body(Subcommand& command, FreeBody& body) {
  command.vector("--inertia", "Principal moments, kg m^2 (default: 1 2 3)", kInertiaRange, body.inertia_B);
  command.vector("--omega", "Angular velocity, rad/s (default: 3 2 4)", kSpeedRange, body.omega_W);
}

void declare(Subcommand& command, CurveOptions& options) {
  declare_body(command, options.body);
  command.app()
      .add_option("--scenario", options.scenario, "A free body's scenario, instead of these two")
      ->type_name("NAME|FILE.json")
      ->excludes("--inertia")
      ->excludes("--omega");
  command.contenders("--contender", options.contenders);
  command.number("--time", "Time at which the error is measured, s (default: 10)", kDurationRange,
                 options.time_s);
  command.number("--dt-from", "Largest step, s (default: 1/15)", kDtRange, options.dt_from_s);
  command.whole_number("--levels", "Number of steps, each half the one before (default: 8)", kLevelRange,
                       options.levels);
  command.whole_number("--rounds", "Rounds of the cost measurement (default: 21)", kRoundRange,
                       options.rounds);
  command.outputs("the points", options.outputs);
}

void declare(Subcommand& command, CostOptions& options) {
  declare_body(command, options.body);
  command.contenders("--contender", options.contenders);
  command.number("--dt", "Length of a step, s (default: 1/60)", kDtRange, options.dt_s);
  command.whole_number("--rounds", "Rounds of the measurement (default: 201)", kRoundRange, options.rounds);
  command.outputs("the costs", options.outputs);
}

void declare_run(Subcommand& command, MapRun& run) {
  command.whole_number("--threads", "Threads of each process (default: one per core; with MPI one)",
                       kThreadRange, run.threads);
  command.app().add_flag("--restart", run.restart, "Start over instead of resuming");
  command.outputs("the map", run.outputs);
}

void declare(Subcommand& command, MapOptions& options) {
  MapGrid& grid = options.grid;
  command.contenders("--contender,--scheme", grid.contenders);
  command.axis("--omega-dt", "|omega| dt, rad: from, to, count (default: 0.01 3 48)", kOmegaDtRange,
               grid.omega_dt);
  command.axis("--inertia-ratio", "I_3/I_1: from, to, count (default: 1.1 20 24)", kRatioRange,
               grid.inertia_ratio);
  command.whole_number("--steps", "Steps of each cell (default: 1000)", kStepsRange, grid.steps);
  command.start(grid.start);
  declare_run(command, options.run);
}

void declare(Subcommand& command, JointsOptions& options) {
  JointsGrid& grid = options.grid;
  command.schemes(grid.contenders);
  command.kinds(grid.kinds);
  command.axis("--omega-dt", "|omega| dt, rad: from, to, count (default: 0.01 3 16)", kJointOmegaDtRange,
               grid.omega_dt);
  command.axis("--inertia-ratio", "I_3/I_1: from, to, count (default: 1 20 8)", kRatioRange,
               grid.inertia_ratio);
  command.axis("--tilt",
               "Angle between the spin and the axis of I_1, rad: from, to, count (default: 0 pi/2 7)",
               kTiltRange, grid.tilt);
  command.number("--dt", "Length of a step, s (default: 1/60)", kJointDtRange, grid.dt_s);
  command.number("--time", "Simulated time of each cell, s (default: 10)", kJointTimeRange, grid.time_s);
  declare_run(command, options.run);
}

void check(const FreeBody& body) {
  if (body.omega_W.isZero(0.0)) throw std::invalid_argument("--omega: is 0; valid is a body that spins");
}

void check(const std::string& command, const MapRun& run) {
  if (run.outputs.csv || run.outputs.json) return;
  throw std::invalid_argument(command + " writes files; valid are --csv FILE, --json FILE or both");
}

}  // namespace

std::optional<WorkPrecisionOptions> parse_work_precision_options(int argument_count, char** arguments) {
  CLI::App app("Compares errors, costs and limits of stability of the schemes and of Bullet.");
  app.set_version_flag("--version", std::string("polhode ") + kVersion);
  app.require_subcommand(1);
  CurveOptions curve;
  CostOptions cost;
  MapOptions map;
  JointsOptions joints;
  Subcommand curve_command(app, "curve", "Error against cost for a series of time steps");
  Subcommand cost_command(app, "cost", "Time that a step takes");
  Subcommand map_command(app, "map", "Energy error over |omega| dt and the inertia ratio");
  Subcommand joints_command(app, "joints",
                            "Joint errors and energy of constrained bodies, compared with Bullet");
  declare(curve_command, curve);
  declare(cost_command, cost);
  declare(map_command, map);
  declare(joints_command, joints);
  if (!parse(app, argument_count, arguments)) return std::nullopt;
  if (curve_command.chosen()) {
    curve_command.read();
    check(curve.body);
    return curve;
  }
  if (cost_command.chosen()) {
    cost_command.read();
    check(cost.body);
    return cost;
  }
  if (joints_command.chosen()) {
    joints_command.read();
    check("joints", joints.run);
    return joints;
  }
  map_command.read();
  check("map", map.run);
  return map;
}

}  // namespace polhode::demos
