#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workprecision/cost_rounds.h"
#include "workprecision/options.h"

namespace polhode::demos {

/// One contender at one time step.
struct CurvePoint {
  std::string contender;
  std::string declared_order;  ///< "2", "exact"; of Bullet's own "1", and "-" without a gyroscopic term
  double dt_s = 0.0;
  std::int64_t steps = 0;
  double worst_energy_error = 0.0;  ///< up to the divergence, if there was one
  std::optional<double> diverged_at_s;
  std::optional<double> attitude_error_rad;  ///< at the end; none if it diverged
  /// log2 of the attitude error at twice the time step over that at this one; none where rounding rules.
  std::optional<double> observed_order;
  std::optional<Cost> cost;

  std::optional<double> ns_per_simulated_second() const;
};

struct Curve {
  FreeBody body;
  double time_s;
  std::vector<CurvePoint> points;  ///< contender by contender, from the largest time step to the smallest
};

/// Does what the options say, files included.
/// @throws std::exception that says what is wrong and what is valid; then no file was written.
Curve curve(const CurveOptions& options);

}  // namespace polhode::demos
