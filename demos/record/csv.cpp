#include "record/csv.h"

#include "record/optional_number.h"
#include "scenario/number_text.h"

namespace polhode::demos {

std::string csv_header() {
  return "contender,step,t_s,q_w,q_x,q_y,q_z,omega_x_rad_s,omega_y_rad_s,omega_z_rad_s,"
         "L_x,L_y,L_z,energy_J,det_R,attitude_error_rad\n";
}

std::string csv_row(const std::string& contender, const Sample& sample) {
  const Quaternion& q_WB = sample.state.q_WB;
  const Vector3& omega_W = sample.state.omega_W;
  const Vector3& L_W = sample.state.L_W;
  std::string row = contender + "," + number_text(sample.step);
  for (const double value : {sample.t_s, q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z(), omega_W.x(), omega_W.y(),
                             omega_W.z(), L_W.x(), L_W.y(), L_W.z(), sample.energy_J, sample.det_R()}) {
    row += "," + full_number_text(value);
  }
  return row + "," + csv_cell(sample.attitude_error_rad) + "\n";
}

}  // namespace polhode::demos
