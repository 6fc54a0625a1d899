#include "record/figure_columns.h"

#include "record/optional_number.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

const std::vector<FigureColumn>& figure_columns() {
  static const std::vector<FigureColumn> all = {
      {"steps", "", 0, &Figures::steps, "recorded steps, without the start"},
      {"final_energy_error", "final\nE/E0-1", 4, &Figures::final_energy_error,
       "relative change of the energy at the end; negative if energy was lost", true},
      {"worst_energy_error", "worst\n|E/E0-1|", 3, &Figures::worst_energy_error,
       "largest magnitude of that change at any step"},
      {"worst_momentum_error", "worst\n|L| error", 3, &Figures::worst_momentum_error,
       "largest ||L|/|L0| - 1|"},
      {"worst_momentum_angle_rad", "turn of\nL, rad", 3, &Figures::worst_momentum_angle_rad,
       "largest angle between L and the initial L"},
      {"final_attitude_error_rad", "attitude\nend, rad", 3, &Figures::final_attitude_error_rad,
       "attitude error at the end: the angle between the orientation and the exact one; \"-\" if unknown"},
      {"worst_attitude_error_rad", "attitude\nmax, rad", 3, &Figures::worst_attitude_error_rad,
       "largest attitude error"},
      {"final_det_R", "final\ndet R", 6, &Figures::final_det_R,
       "1 for a rotation, else the factor by which the body's volume has changed"},
      {"steps_past_cut", "fast\nsteps", 0, &Figures::steps_past_cut,
       "steps after which |omega| dt > pi/4, where Bullet turns less than the velocity it reports"},
      {"diverged_at_s", "diverged\nat t, s", 6, &Figures::diverged_at_s,
       "end of the step that failed; \"-\" if none did"},
      {"ns_per_step", "ns per\nstep", 0, &Figures::ns_per_step,
       "wall-clock time of stepSimulation: median of the steps, including about 50 ns for reading the clock"},
  };
  return all;
}

Json FigureColumn::value(const Figures& figures) const {
  if (const auto* count = std::get_if<std::int64_t Figures::*>(&member)) return figures.*(*count);
  if (const auto* number = std::get_if<double Figures::*>(&member)) return figures.*(*number);
  return json_value(figures.*std::get<std::optional<double> Figures::*>(member));
}

std::string FigureColumn::cell(const Figures& figures) const {
  const Json json = value(figures);
  if (json.is_null()) return "-";
  const double number = json.get<double>();
  if (digits == 0) return number_text(static_cast<std::int64_t>(number));
  return (has_sign && number > 0.0 ? "+" : "") + short_number_text(number, digits);
}

}  // namespace polhode::demos
