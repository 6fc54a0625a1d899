#include "polhode/rotation_math.h"
#include "workprecision/kernel.h"

namespace polhode::demos {

namespace {

class SchemeKernel final : public Kernel {
 public:
  SchemeKernel(SchemePointer scheme, const FreeBody& body, double dt_s, Kick kick)
      : scheme_(std::move(scheme)) {
    set_orientation(start_, body.q_WB);
    set_omega(start_, body.inertia_B, body.omega_W);
    state_ = start_;
    const double change = kick == Kick::every_step ? kKick : 0.0;
    input_ = StepInput{body.inertia_B, Vector3::Constant(change), dt_s};
  }

  void restart() override { state_ = start_; }

  void run(std::int64_t steps) override {
    for (std::int64_t step = 0; step < steps; ++step) scheme_->step(input_, state_);
  }

  RotationState state() const override { return state_; }
  Vector3 inertia_B() const override { return input_.inertia_B; }
  double dt_s() const override { return input_.dt; }

 private:
  SchemePointer scheme_;
  StepInput input_;
  RotationState start_;
  RotationState state_;
};

}  // namespace

std::unique_ptr<Kernel> make_scheme_kernel(const SchemePointer& scheme, const FreeBody& body, double dt_s,
                                           Kick kick) {
  return std::make_unique<SchemeKernel>(scheme, body, dt_s, kick);
}

}  // namespace polhode::demos
