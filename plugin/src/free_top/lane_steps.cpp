#include "free_top/lane_steps.h"

#include <cstddef>
#include <cstdint>

#include "free_top/momentum_match.h"
#include "lanes/instruction_sets.h"

namespace polhode::free_top {

namespace {

// The bodies at the start of the step.
struct LaneStart {
  QuaternionL q_WB;
  Matrix3L R_WB;
  Vector3L L_W;

  POLHODE_INLINE explicit LaneStart(const LaneBodies& bodies)
      : q_WB(bodies.of_state(&RotationState::q_WB)),
        R_WB(q_WB.toRotationMatrix()),  // fewer operations than to gather it
        L_W(bodies.of_state(&RotationState::L_W)) {}

  POLHODE_INLINE Vector3L to_B(const Vector3L& v_W) const { return R_WB.transpose() * v_W; }
};

// The bodies at its end.
struct LaneEnd {
  QuaternionL q_WB;
  Matrix3L R_WB;
  Vector3L omega_W;

  // turned_WB is of unit length but for rounding, so that one Newton step makes it so.
  POLHODE_INLINE LaneEnd(const QuaternionL& turned_WB, const Vector3L& inertia_B, const Vector3L& L_W)
      : q_WB(turned_WB.coeffs() * (1.5 - 0.5 * turned_WB.coeffs().squaredNorm())),
        R_WB(q_WB.toRotationMatrix()),
        omega_W(R_WB * Vector3L(R_WB.transpose() * L_W).cwiseQuotient(inertia_B)) {}

  POLHODE_INLINE void store(std::size_t lane, RotationState& state) const {
    for (int i = 0; i < 4; ++i) state.q_WB.coeffs()[i] = q_WB.coeffs()[i][lane];
    for (int i = 0; i < 9; ++i) state.R_WB.coeffRef(i) = R_WB.coeff(i)[lane];
    for (int i = 0; i < 3; ++i) state.omega_W[i] = omega_W[i][lane];
  }
};

template <std::size_t size>
POLHODE_INLINE std::array<double, size> in_lane(std::size_t lane, const std::array<Lanes, size>& values) {
  std::array<double, size> result;
  for (std::size_t i = 0; i < size; ++i) result[i] = values[i][lane];
  return result;
}

POLHODE_INLINE Substep<double> in_lane(std::size_t lane, const Substep<Lanes>& substep) {
  return {in_lane(lane, substep.mu),
          substep.cn[lane],
          substep.dn[lane],
          in_lane(lane, substep.slope),
          in_lane(lane, substep.pull_12),
          in_lane(lane, substep.pull_23)};
}

// Short steps, made as make_free_top_step does it.
struct MadeSteps {
  Axes<Lanes> axes;
  Triple<Lanes> L;
  Substep<Lanes> substep;
  LaneMask is_good;  // where not, the step is not short, or the body is at rest

  POLHODE_INLINE MadeSteps(const Vector3L& inertia_B, const Vector3L& L_B, const Lanes& dt) {
    const Lanes length = sqrt(L_B.squaredNorm());
    const auto body = labelled<Lanes>(inertia_B, Vector3L(L_B / length));
    const Motion<Lanes> motion = motion_of(body.inertia, body.u, Lanes(length * dt));
    axes = body.axes;
    L = in_order(axes, L_B);
    substep = make_substep(motion, body.parity, length, Lanes(0.0));
    is_good = is_short(motion) & (length >= kAtRest);
  }

  POLHODE_INLINE void store(std::size_t lane, const StepInput& input, FreeTopStep& step) const {
    step.inertia_B = {input.inertia_B.x(), input.inertia_B.y(), input.inertia_B.z()};
    step.dt = input.turn_dt;
    for (std::size_t i = 0; i < 3; ++i) step.axes[i] = static_cast<std::uint8_t>(axes[i][lane]);
    step.substeps = 1;
    step.substep = in_lane(lane, substep);
    step.cos_about_L = 1.0;
    step.sin_about_L_per_length = 0.0;
  }
};

}  // namespace

POLHODE_FOR_EACH_INSTRUCTION_SET
LanesLeft take_steps(const LaneBodies& bodies) noexcept {
  const LaneStart start(bodies);
  const Axes<Lanes> axes = bodies.axes();
  const Triple<Lanes> L = bodies.of_step(&FreeTopStep::L);
  const Vector3L L_B = in_body(axes, L);
  const Vector3L found_L_B = start.to_B(start.L_W);
  const LaneMask fits = is_same_momentum(L_B, found_L_B);

  const Substep<Lanes> substep = bodies.substep();
  const Triple<Lanes> next = moved(substep, L);
  const QuaternionL rho_B = alignment(L_B, found_L_B) * turn_of(substep, axes, L, next);
  const auto [I_x, I_y, I_z] = bodies.of_step(&FreeTopStep::inertia_B);
  const LaneEnd end(start.q_WB * rho_B, Vector3L(I_x, I_y, I_z), start.L_W);
  LanesLeft left;
  for (std::size_t lane = 0; lane < bodies.count(); ++lane) {
    if (fits[lane]) {
      end.store(lane, *bodies.body(lane).state);
      bodies.step(lane).L = in_lane(lane, next);
    } else {
      left.set(lane);
    }
  }
  return left;
}

POLHODE_FOR_EACH_INSTRUCTION_SET
LanesLeft make_and_take_steps(const LaneBodies& bodies) noexcept {
  const LaneStart start(bodies);
  const Vector3L inertia_B = bodies.of_input(&StepInput::inertia_B);
  const Vector3L delta_omega_B = start.to_B(bodies.of_input(&StepInput::delta_omega_W));
  const Vector3L L_W = start.L_W + start.R_WB * inertia_B.cwiseProduct(delta_omega_B);
  const MadeSteps made(inertia_B, start.to_B(L_W), bodies.of_input(&StepInput::turn_dt));

  const Triple<Lanes> next = moved(made.substep, made.L);
  const LaneEnd end(start.q_WB * turn_of(made.substep, made.axes, made.L, next), inertia_B, L_W);
  LanesLeft left;
  for (std::size_t lane = 0; lane < bodies.count(); ++lane) {
    if (made.is_good[lane]) {
      RotationState& state = *bodies.body(lane).state;
      for (int i = 0; i < 3; ++i) state.L_W[i] = L_W[i][lane];
      end.store(lane, state);
      made.store(lane, *bodies.body(lane).input, bodies.step(lane));
      bodies.step(lane).L = in_lane(lane, next);
    } else {
      left.set(lane);
    }
  }
  return left;
}

}  // namespace polhode::free_top
