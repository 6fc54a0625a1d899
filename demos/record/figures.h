#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/sample.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// The results of a run: a row of the table. All of them are measured up to the divergence, if there was one.
/// Errors relative to an energy or momentum that is zero at the start are absent. The attitude's error is
/// absent where the exact motion is not known.
struct Figures {
  std::int64_t steps = 0;                          ///< recorded, without the start
  std::optional<double> final_energy_error;        ///< E/E0 - 1: below 0 energy was lost
  std::optional<double> worst_energy_error;        ///< the largest |E/E0 - 1|
  std::optional<double> worst_momentum_error;      ///< the largest ||L|/|L0| - 1|
  std::optional<double> worst_momentum_angle_rad;  ///< the largest angle between L and L0
  std::optional<double> final_attitude_error_rad;
  std::optional<double> worst_attitude_error_rad;
  double final_det_R = 1.0;
  std::int64_t steps_past_cut = 0;  ///< in which |omega| dt > pi/4: Bullet's own turn is cut there
  std::optional<double> diverged_at_s;
  double ns_per_step = 0.0;
};

/// Gathers the figures of a run sample by sample.
class FiguresRecorder {
 public:
  FiguresRecorder(const Sample& start, double dt);
  void add(const Sample& sample);
  /// The step to this time failed: it is not in the figures.
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
  Scenario scenario;      ///< as run, with the inertia that follows from its shape
  std::string precision;  ///< of Bullet: "single" or "double"
  std::vector<ContenderFigures> contenders;
  std::string note;  ///< on the choice of contenders; one line, or empty
};

}  // namespace polhode::demos
