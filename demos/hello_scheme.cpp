// A rotation scheme of your own, in a library that the demos can load:
//
//   polhode_compare --scheme-library hello_scheme.so
//
// With constant angular momentum L_W the axis of rotation moves with the body. The scheme predicts the
// orientation in the middle of the step and turns the body about the axis at this orientation (a midpoint
// rule, order 2):
//
//   q_m     = exp((dt/2) I^-1(q_t) L) q_t      (1)
//   q_{t+1} = exp(dt I^-1(q_m) L) q_t          (2)
#include <polhode/rotation_math.h>
#include <polhode/scheme_library.h>

#include <memory>

namespace {

class ExplicitMidpoint final : public polhode::RotationScheme {
 public:
  polhode::SchemeDescription description() const noexcept override {
    polhode::SchemeDescription description;
    description.name = "explicit_midpoint";
    description.summary = "turns about the axis of the middle of the step, predicted by Euler's rule";
    description.source = "a Runge-Kutta method of order 2 in the exponential map";
    description.fails_when = "a step turns the body by about a radian";
    description.order = 2;
    description.angular_momentum = polhode::Conservation::exact;
    return description;
  }

  void step(const polhode::StepInput& input, polhode::RotationState& state) const noexcept override {
    // The kick: what torques and impulses add to the angular momentum.
    const polhode::Vector3 L_W =
        state.L_W + polhode::angular_momentum_W(state.R_WB, input.inertia_B, input.delta_omega_W);
    const polhode::Quaternion q_m = turned(state.q_WB, state.R_WB, input, L_W, input.dt / 2);  // (1)
    const polhode::Quaternion q_end =
        turned(state.q_WB, q_m.toRotationMatrix(), input, L_W, input.dt);  // (2)
    polhode::set_orientation(state, q_end);
    polhode::set_angular_momentum(state, input.inertia_B, L_W);
  }

 private:
  // Turns q_WB for `time` with the angular velocity at the orientation R_WB.
  static polhode::Quaternion turned(const polhode::Quaternion& q_WB, const polhode::Matrix3& R_WB,
                                    const polhode::StepInput& input, const polhode::Vector3& L_W,
                                    double time) {
    const polhode::Vector3 omega_W = polhode::inverse_inertia_W(R_WB, input.inertia_B) * L_W;
    return (polhode::exponential(omega_W * time) * q_WB).normalized();
  }
};

}  // namespace

POLHODE_SCHEME_LIBRARY(std::make_shared<ExplicitMidpoint>())
