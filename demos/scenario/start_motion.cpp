#include "scenario/start_motion.h"

#include <algorithm>
#include <stdexcept>

#include "polhode/rotation_limits.h"
#include "polhode/rotation_math.h"
#include "scenario/number_text.h"

namespace polhode::demos {

StartMotion start_motion(const Body& body, const Vector3& inertia_B) {
  StartMotion motion{body.omega_W, body.velocity_W};
  const Matrix3 inverse_I_W = inverse_inertia_W(body.q_WB.toRotationMatrix(), inertia_B);
  for (const Impulse& impulse : body.impulses) {
    motion.omega_W += inverse_I_W * impulse.at_W.cross(impulse.impulse_W);
    motion.velocity_W += impulse.impulse_W / body.mass;
  }
  const double fastest = std::max(motion.omega_W.norm(), motion.velocity_W.norm());
  if (!(fastest <= kMaximumAngularSpeed)) {
    throw std::invalid_argument(
        "\"angular_velocity\", \"linear_velocity\", \"impulses\": together they make " +
        short_number_text(fastest, 3) + " rad/s or m/s; valid is at most " +
        number_text(kMaximumAngularSpeed));
  }
  return motion;
}

}  // namespace polhode::demos
