#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "workprecision/cost_rounds.h"
#include "workprecision/options.h"

namespace polhode::demos {

/// Results of one contender at one time step.
struct CurvePoint {
  std::string contender;
  std::string declared_order;  ///< "2", "exact"; for Bullet "1", or "-" without a gyroscopic term
  double dt_s = 0.0;
  std::int64_t steps = 0;
  double worst_energy_error = 0.0;  ///< up to the divergence, if there is one
  std::optional<double> diverged_at_s;
  std::optional<double> attitude_error_rad;  ///< at the end; none if the body diverged
  /// log2 of the attitude error at twice the time step over that at this one; none where rounding dominates.
  std::optional<double> observed_order;
  std::optional<Cost> cost;

  std::optional<double> ns_per_simulated_second() const;
};

struct Curve {
  FreeBody body;
  double time_s;
  std::vector<CurvePoint> points;  ///< contender by contender, from the largest time step to the smallest
};

/// Returns the body of a scenario.
/// @throws std::invalid_argument if it is not free, or does not spin
FreeBody free_body(const Scenario& scenario);

/// Receives the number of contenders that are done, and the name of the last one.
using CurveProgress = std::function<void(std::int64_t done, const std::string& contender)>;

/// Measures the curve of `options.body`.
/// @throws std::invalid_argument for less than one step, or more than kMostSteps; Interrupted
Curve measure_curve(const CurveOptions& options, const CurveProgress& progress);

/// Runs the measurement that the options describe and writes its files.
/// @throws std::exception that says what is wrong and what is valid; no file is written then
Curve curve(const CurveOptions& options);

}  // namespace polhode::demos
