#include "workprecision/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "command_line/progress_bar.h"
#include "oracle/free_top.h"
#include "scenario/named_error.h"
#include "scenario/scenario_directory.h"
#include "scenario/start_motion.h"
#include "workprecision/curve_text.h"
#include "workprecision/motion.h"
#include "workprecision/output_files.h"
#include "world/body_shape.h"

namespace polhode::demos {

namespace {

std::string declared_order(const Contender& contender) {
  if (const SchemePointer* scheme = std::get_if<SchemePointer>(&contender.method)) {
    return order_text((*scheme)->description().order);
  }
  const BulletMode* mode = std::get_if<BulletMode>(&contender.method);
  return mode != nullptr && *mode == BulletMode::none ? "-" : "1";
}

// Returns the final error against the exact motion from the kernel's own start, so that Bullet's rounding of
// the start does not count.
std::optional<double> attitude_error_rad(Kernel& kernel, const Motion& motion) {
  if (motion.diverged) return std::nullopt;
  const Quaternion q_WB = kernel.state().q_WB;
  kernel.restart();
  const RotationState start = kernel.state();
  const oracle::FreeTop exact(kernel.inertia_B(), start.q_WB, start.L_W);
  return exact.attitude_error_after(q_WB, motion.steps, kernel.dt_s());
}

CurvePoint measured_point(const Contender& contender, Kernel& kernel, std::int64_t steps) {
  const Motion motion = follow(kernel, steps);
  CurvePoint point;
  point.contender = contender.name;
  point.declared_order = declared_order(contender);
  point.dt_s = kernel.dt_s();
  point.steps = motion.steps;
  point.worst_energy_error = motion.worst_energy_error;
  if (motion.diverged) point.diverged_at_s = kernel.dt_s() * static_cast<double>(motion.steps + 1);
  point.attitude_error_rad = attitude_error_rad(kernel, motion);
  return point;
}

void add_observed_order(CurvePoint& point, const CurvePoint& at_twice_the_dt) {
  constexpr double kRoundingError = 1e-12;  // rad
  // A missing error compares as less than any number.
  if (std::min(point.attitude_error_rad, at_twice_the_dt.attitude_error_rad) < kRoundingError) return;
  point.observed_order = std::log2(*at_twice_the_dt.attitude_error_rad / *point.attitude_error_rad);
}

// The time steps of one contender; keeps the kernels for the cost measurement.
class Ladder {
 public:
  Ladder(const CurveOptions& options, const FreeBody& body)
      : options_(options),
        body_(body),
        coarsest_steps_(static_cast<std::int64_t>(std::llround(options.time_s / options.dt_from_s))) {
    if (coarsest_steps_ < 1) throw std::invalid_argument("--time: is less than one step of --dt-from");
    if (std::ldexp(static_cast<double>(coarsest_steps_), static_cast<int>(options.levels - 1)) > kMostSteps) {
      throw std::invalid_argument("--time, --dt-from, --levels: more than 1e+08 steps; valid is fewer");
    }
  }

  std::int64_t steps(std::int64_t level) const { return coarsest_steps_ << level; }

  std::unique_ptr<Kernel> kernel(const Contender& contender, std::int64_t level) const {
    return make_kernel(contender, body_, options_.time_s / static_cast<double>(steps(level)));
  }

 private:
  const CurveOptions& options_;
  const FreeBody& body_;
  std::int64_t coarsest_steps_;
};

void add_costs(const CurveOptions& options, const Ladder& ladder,
               const std::vector<std::unique_ptr<Kernel>>& kernels, std::vector<CurvePoint>& points) {
  std::vector<Lap> laps;
  const auto levels = static_cast<std::size_t>(options.levels);
  const Contender baseline = find_contenders({kBaseline}).front();
  std::vector<std::unique_ptr<Kernel>> baselines;
  for (std::int64_t level = 0; level < options.levels; ++level) {
    baselines.push_back(ladder.kernel(baseline, level));
    laps.push_back({baselines.back().get(), ladder.steps(level), laps.size()});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    laps.push_back({kernels[i].get(), points[i].steps, i % levels});
  }
  const std::vector<std::optional<Cost>> costs = measure_costs(laps, options.rounds);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].cost = costs[levels + i];
}

}  // namespace

std::optional<double> CurvePoint::ns_per_simulated_second() const {
  return cost ? std::optional(cost->ns_per_step / dt_s) : std::nullopt;
}

FreeBody free_body(const Scenario& scenario) {
  if (!scenario.is_torque_free() || scenario.has_rotors()) {
    throw std::invalid_argument(
        "not a free body; valid is one without torque, torque law, rotors, damping, constraint, ground and "
        "others");
  }
  const Vector3 inertia_B = *resolved(scenario).body.inertia_B;
  const FreeBody body{inertia_B, scenario.body.q_WB, start_motion(scenario.body, inertia_B).omega_W};
  if (body.omega_W.isZero(0.0)) throw std::invalid_argument("does not spin; valid is a body that spins");
  return body;
}

Curve measure_curve(const CurveOptions& options, const CurveProgress& progress) {
  Curve curve{options.body, options.time_s, {}};
  const Ladder ladder(options, curve.body);
  std::vector<std::unique_ptr<Kernel>> kernels;
  for (const Contender& contender : options.contenders) {
    for (std::int64_t level = 0; level < options.levels; ++level) {
      kernels.push_back(ladder.kernel(contender, level));
      CurvePoint point = measured_point(contender, *kernels.back(), ladder.steps(level));
      if (level > 0) add_observed_order(point, curve.points.back());
      curve.points.push_back(point);
    }
    progress(static_cast<std::int64_t>(kernels.size()) / options.levels, contender.name);
  }
  add_costs(options, ladder, kernels, curve.points);
  return curve;
}

Curve curve(const CurveOptions& options) {
  OutputFiles files(options.outputs.csv, options.outputs.json);
  CurveOptions of_scenario = options;
  if (options.scenario) {
    of_scenario.body =
        naming_the_scenario(*options.scenario, [&] { return free_body(find_scenario(*options.scenario)); });
  }
  ProgressBar bar(static_cast<std::int64_t>(options.contenders.size()));
  const Curve result = measure_curve(
      of_scenario, [&](std::int64_t done, const std::string& contender) { bar.show(done, contender); });
  files.write(curve_csv(result), curve_json(result));
  return result;
}

}  // namespace polhode::demos
