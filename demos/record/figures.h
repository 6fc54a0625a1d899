#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/sample.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// The results of a run: a row of the table. They are measured up to the divergence, if there is one. Errors
/// relative to an energy or momentum that is zero at the start are absent. The attitude error is absent if
/// the exact motion is unknown.
struct Figures {
  std::int64_t steps = 0;                          ///< recorded steps, without the start
  std::optional<double> final_energy_error;        ///< E/E0 - 1; negative if energy was lost
  std::optional<double> worst_energy_error;        ///< the largest |E/E0 - 1|
  std::optional<double> worst_momentum_error;      ///< the largest ||L|/|L0| - 1|
  std::optional<double> worst_momentum_angle_rad;  ///< the largest angle between L and L0
  std::optional<double> final_attitude_error_rad;
  std::optional<double> worst_attitude_error_rad;
  double final_det_R = 1.0;
  std::int64_t steps_past_cut = 0;  ///< steps with |omega| dt > pi/4, where Bullet limits the turn
  std::optional<double> diverged_at_s;
  double ns_per_step = 0.0;
};

/// Computes the figures of a run sample by sample.
class FiguresRecorder {
 public:
  FiguresRecorder(const Sample& start, double dt);
  void add(const Sample& sample);
  /// Records that the step to this time failed; it does not count in the figures.
  void set_diverged(double t_s) { figures_.diverged_at_s = t_s; }
  void set_ns_per_step(double ns) { figures_.ns_per_step = ns; }
  const Figures& figures() const { return figures_; }

 private:
  void add_errors(const Sample& sample);

  Sample start_;
  double dt_;
  Figures figures_;
};

struct ContenderFigures {
  std::string contender;
  Figures figures;
};

/// Contenders side by side in one scenario.
struct Comparison {
  Scenario scenario;      ///< as run, including the inertia that follows from the shape
  std::string precision;  ///< of Bullet: "single" or "double"
  std::vector<ContenderFigures> contenders;
  std::string note;  ///< about the choice of contenders; one line, or empty
};

}  // namespace polhode::demos
