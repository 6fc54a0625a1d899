#include "free_top/wide_steps.h"

#include "free_top/momentum_match.h"
#include "scheme_base/kick_and_turn.h"
#include "simd/instruction_sets.h"

namespace polhode::free_top {

namespace {

using WideStep = FreeTopStep<Wide>;

POLHODE_INLINE WideStep load(const Wide* memory) {
  WideStep step;
  WideStep::for_each_number(step, [memory](Wide& number, std::size_t i) { number = memory[i]; });
  return step;
}

// Stores the lanes of the mask.
POLHODE_INLINE void store(const WideStep& step, const WideMask& mask, Wide* memory) {
  WideStep::for_each_number(
      step, [&](const Wide& number, std::size_t i) { memory[i] = select(mask, number, memory[i]); });
}

// Stores only L, since a step of a free body changes nothing else.
POLHODE_INLINE void store_L(const Triple<Wide>& L, const WideMask& mask, Wide* memory) {
  constexpr std::size_t kFirst = 1;
  if (all(mask)) {
    for (std::size_t i = 0; i < 3; ++i) memory[kFirst + i] = L[i];
  } else {
    for (std::size_t i = 0; i < 3; ++i) memory[kFirst + i] = select(mask, L[i], memory[kFirst + i]);
  }
}

// Returns the lanes whose step was prepared for this dt and that are not kicked now.
POLHODE_INLINE WideMask is_prepared_for(const WideStepInput& input, const WideStep& step) {
  WideDifferences differences;
  differences.add(step.dt, input.dt);
  for (int i = 0; i < 3; ++i) differences.add(input.delta_omega_W[i] + 0.0, 0.0);  // -0 + 0 is 0
  return differences.are_none();
}

// Short steps, prepared as by make_free_top_step.
struct MadeSteps {
  WideStep step;
  Axes<Wide> axes;
  WideMask are_short;
  WideMask is_at_rest;

  POLHODE_INLINE MadeSteps(const Vector3Wide& inertia_B, const Vector3Wide& L_B, const Wide& dt) {
    const Wide length = sqrt(L_B.squaredNorm());
    const auto body = labelled<Wide>(inertia_B, Vector3Wide(L_B / length));
    const Motion<Wide> motion = motion_of(body.inertia, body.u, Wide(length * dt));
    axes = body.axes;
    step = {order_of(axes),
            in_order(axes, L_B),
            dt,
            make_substep(motion, body.parity, length, Wide(0.0)),
            1.0,
            0.0};
    is_at_rest = length < kAtRest;
    are_short = is_short(motion) & !is_at_rest;
  }
};

// The bodies after their turn.
struct Turned {
  QuaternionWide q_WB;  // of unit length up to rounding
  Vector3Wide L_W;
};

POLHODE_INLINE Turned select(const WideMask& mask, const Turned& a, const Turned& b) {
  return {QuaternionWide(select(mask, a.q_WB.coeffs(), b.q_WB.coeffs())), select(mask, a.L_W, b.L_W)};
}

// `start` is the state before the step. Bodies at rest keep its orientation bit for bit.
POLHODE_INLINE WideState end_of(const Turned& turned, const Vector3Wide& inertia_B,
                                const WideMask& is_at_rest, const WideState& start) {
  WideState end;
  // One Newton step normalizes the quaternion.
  set_orientation(end,
                  QuaternionWide(turned.q_WB.coeffs() * (1.5 - 0.5 * turned.q_WB.coeffs().squaredNorm())));
  if (any(is_at_rest)) {
    end.q_WB.coeffs() = select(is_at_rest, start.q_WB.coeffs(), end.q_WB.coeffs());
    end.R_WB = select(is_at_rest, start.R_WB, end.R_WB);
  }
  set_angular_momentum(end, inertia_B, turned.L_W);
  return end;
}

// Steps of all bodies as free ones; the caller selects the free bodies.
struct FreeSteps {
  Turned turned;
  Triple<Wide> next_L;

  POLHODE_INLINE FreeSteps(const WideStep& step, const Axes<Wide>& axes, const Vector3Wide& L_B,
                           const Vector3Wide& found_L_B, const WideState& state)
      : next_L(moved(step.substep, step.L)) {
    const QuaternionWide rho_B = alignment(L_B, found_L_B) * turn_of(step.substep, axes, step.L, next_L);
    turned = {state.q_WB * rho_B, state.L_W};
  }
};

// Steps after a kick, or first steps.
struct ChangedSteps {
  MadeSteps made;
  Turned turned;

  POLHODE_INLINE ChangedSteps(const WideStepInput& input, const WideState& state, const Vector3Wide& L_W)
      : made(input.inertia_B, state.R_WB.transpose() * L_W, input.dt) {
    const Triple<Wide> next_L = moved(made.step.substep, made.step.L);
    turned = {state.q_WB * turn_of(made.step.substep, made.axes, made.step.L, next_L), L_W};
    made.step.L = next_L;
  }
};

POLHODE_FOR_EACH_INSTRUCTION_SET
void take_short_steps(const WideStepInput& input, const WideMask& mask, WideState& state, Wide* memory,
                      std::bitset<kLanes>& left) noexcept {
  WideMask is_free = WideMask::from_bits(0);
  WideMask is_long = is_free;
  WideMask is_at_rest = is_free;
  Turned turned;
  if (memory != nullptr) {
    const WideStep stored = load(memory);
    const Axes<Wide> axes = axes_of(stored.kind);
    const Vector3Wide L_B = in_body(axes, stored.L);
    const Vector3Wide found_L_B = state.R_WB.transpose() * state.L_W;
    const WideMask is_prepared = mask & is_prepared_for(input, stored);
    is_free = is_prepared & is_short(stored) & is_same_momentum(L_B, found_L_B);
    is_long = is_prepared & !is_short(stored);
    if (any(is_free)) {
      const FreeSteps free(stored, axes, L_B, found_L_B, state);
      turned = free.turned;
      store_L(free.next_L, is_free, memory);
    }
  }

  WideMask is_taken = is_free;
  const WideMask is_other = mask & !(is_free | is_long);
  if (any(is_other)) {
    const ChangedSteps changed(input, state, schemes::kicked_L_W<Wide>(input, state));
    const WideMask is_changed = is_other & changed.made.are_short;
    if (memory != nullptr) store(changed.made.step, is_changed, memory);
    turned = any(is_free) ? select(is_free, turned, changed.turned) : changed.turned;
    is_at_rest = is_other & changed.made.is_at_rest;
    is_taken = is_free | is_changed | is_at_rest;
  }
  left = (mask & !is_taken).bits();
  if (!any(is_taken)) return;
  const WideState end = end_of(turned, input.inertia_B, is_at_rest, state);
  state = all(is_taken) ? end : select(is_taken, end, state);
}

}  // namespace

std::bitset<kLanes> take_short_steps(const WideStepInput& input, const WideMask& mask, WideState& state,
                                     Wide* memory) noexcept {
  std::bitset<kLanes> left;
  take_short_steps(input, mask, state, memory, left);
  return left;
}

void get_lane(std::size_t lane, const Wide* memory, FreeTopStep<double>& result) {
  FreeTopStep<double>::for_each_number(result,
                                       [=](double& number, std::size_t i) { number = memory[i][lane]; });
}

void set_lane(std::size_t lane, const FreeTopStep<double>& step, Wide* memory) {
  FreeTopStep<double>::for_each_number(step,
                                       [=](double number, std::size_t i) { memory[i].set(lane, number); });
}

}  // namespace polhode::free_top
