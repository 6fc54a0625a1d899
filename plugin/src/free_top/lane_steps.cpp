#include "free_top/lane_steps.h"

#include <cstddef>

#include "free_top/momentum_match.h"
#include "lanes/instruction_sets.h"
#include "lanes/lane_rows.h"

namespace polhode::free_top {

namespace {

using Steps = std::array<FreeTopStep*, kLanes>;

// A FreeTopStep is rows of four numbers.
constexpr std::size_t kRow = 4;
static_assert(sizeof(FreeTopStep) == 22 * sizeof(double), "the rows below are no longer its members");

POLHODE_INLINE auto row_of(const Steps& steps, std::size_t row) {
  return [&steps, row](std::size_t lane) { return &steps[lane]->kind + kRow * row; };
}

POLHODE_INLINE LaneRowsOfFour<double> load_row(const Steps& steps, std::size_t row) {
  return load_rows_of_four<double>(row_of(steps, row));
}

// The FreeTopSteps of eight bodies.
struct LaneSteps {
  Lanes kind;
  Triple<Lanes> L;
  Vector3L inertia_B;
  Lanes dt;
  Substep<Lanes> substep;

  POLHODE_INLINE static LaneSteps load(const Steps& steps) {
    const LaneRowsOfFour<double> row_0 = load_row(steps, 0), row_1 = load_row(steps, 1),
                                 row_2 = load_row(steps, 2), row_3 = load_row(steps, 3),
                                 row_4 = load_row(steps, 4);
    return {row_0.x,
            {row_0.y, row_0.z, row_0.w},
            Vector3L(row_1.x, row_1.y, row_1.z),
            row_1.w,
            {{row_2.x, row_2.y, row_2.z},
             row_2.w,
             row_3.x,
             {row_3.y, row_3.z, row_3.w},
             {row_4.x, row_4.y},
             {row_4.z, row_4.w}}};
  }

  // Those of the lanes in the mask.
  POLHODE_INLINE void store(const Steps& steps, const std::bitset<kLanes>& mask) const {
    FreeTopStep unwanted;
    Steps targets;
    for (std::size_t lane = 0; lane < kLanes; ++lane) targets[lane] = mask[lane] ? steps[lane] : &unwanted;
    const auto store_row = [&targets](std::size_t row, const LaneRowsOfFour<double>& values) {
      store_rows_of_four(values, row_of(targets, row));
    };
    store_row(0, {kind, L[0], L[1], L[2]});
    store_row(1, {inertia_B[0], inertia_B[1], inertia_B[2], dt});
    store_row(2, {substep.mu[0], substep.mu[1], substep.mu[2], substep.cn});
    store_row(3, {substep.dn, substep.slope[0], substep.slope[1], substep.slope[2]});
    store_row(4, {substep.pull_12[0], substep.pull_12[1], substep.pull_23[0], substep.pull_23[1]});
    for (FreeTopStep* step : targets) {
      step->cos_about_L = 1.0;
      step->sin_about_L_per_length = 0.0;
    }
  }

  POLHODE_INLINE LaneMask is_short() const { return kind < FreeTopStep::kOrders; }
  // Made for these bodies, on which nothing acts now.
  POLHODE_INLINE LaneMask are_prepared_for(const LaneInput& input) const {
    LaneDifferences differences;
    differences.add(dt, input.turn_dt);
    for (int i = 0; i < 3; ++i) {
      differences.add(inertia_B[i], input.inertia_B[i]);
      differences.add(input.delta_omega_W[i] + 0.0, 0.0);  // -0 + 0 is 0
    }
    return differences.are_none();
  }
};

// Short steps, made as make_free_top_step does it.
struct MadeSteps {
  LaneSteps steps;
  Axes<Lanes> axes;
  LaneMask is_good;  // where not, the step is not short, or the body is at rest

  POLHODE_INLINE MadeSteps(const Vector3L& inertia_B, const Vector3L& L_B, const Lanes& dt) {
    const Lanes length = sqrt(L_B.squaredNorm());
    const auto body = labelled<Lanes>(inertia_B, Vector3L(L_B / length));
    const Motion<Lanes> motion = motion_of(body.inertia, body.u, Lanes(length * dt));
    axes = body.axes;
    steps = {order_of(axes), in_order(axes, L_B), inertia_B, dt,
             make_substep(motion, body.parity, length, Lanes(0.0))};
    is_good = is_short(motion) & (length >= kAtRest);
  }
};

// The bodies half way through their step.
struct Turned {
  QuaternionL q_WB;  // of unit length but for rounding
  Vector3L L_W;
};

POLHODE_INLINE Turned select(const LaneMask& mask, const Turned& a, const Turned& b) {
  return {QuaternionL(select(mask, a.q_WB.coeffs(), b.q_WB.coeffs())), select(mask, a.L_W, b.L_W)};
}

POLHODE_INLINE LaneState end_of(const Turned& turned, const Vector3L& inertia_B) {
  LaneState end;
  end.L_W = turned.L_W;
  // One Newton step makes it of unit length.
  set_orientation(end, QuaternionL(turned.q_WB.coeffs() * (1.5 - 0.5 * turned.q_WB.coeffs().squaredNorm())));
  set_angular_momentum(end, inertia_B, turned.L_W);
  return end;
}

// A step of every body, of which the caller takes those that are free.
struct FreeSteps {
  Turned turned;
  Triple<Lanes> next_L;

  POLHODE_INLINE FreeSteps(const LaneSteps& steps, const Axes<Lanes>& axes, const Vector3L& L_B,
                           const Vector3L& found_L_B, const LaneState& state)
      : next_L(moved(steps.substep, steps.L)) {
    const QuaternionL rho_B = alignment(L_B, found_L_B) * turn_of(steps.substep, axes, steps.L, next_L);
    turned = {state.q_WB * rho_B, state.L_W};
  }
};

// The same after a kick, or for the first time.
struct ChangedSteps {
  MadeSteps made;
  Turned turned;

  POLHODE_INLINE static Vector3L kicked_L_W(const LaneInput& input, const LaneState& state) {
    const Vector3L delta_omega_B = state.R_WB.transpose() * input.delta_omega_W;
    return state.L_W + state.R_WB * input.inertia_B.cwiseProduct(delta_omega_B);
  }

  POLHODE_INLINE ChangedSteps(const LaneInput& input, const LaneState& state, const Vector3L& L_W)
      : made(input.inertia_B, state.R_WB.transpose() * L_W, input.turn_dt) {
    const Triple<Lanes> next_L = moved(made.steps.substep, made.steps.L);
    turned = {state.q_WB * turn_of(made.steps.substep, made.axes, made.steps.L, next_L), L_W};
    made.steps.L = next_L;
  }
};

}  // namespace

POLHODE_FOR_EACH_INSTRUCTION_SET
void take_steps(const LaneInput& input, const Steps& steps, LaneState& state, LanesLeft& left) noexcept {
  const LaneSteps stored = LaneSteps::load(steps);
  const Axes<Lanes> axes = axes_of(stored.kind);
  const Vector3L L_B = in_body(axes, stored.L);
  const Vector3L found_L_B = state.R_WB.transpose() * state.L_W;
  const LaneMask is_prepared = stored.are_prepared_for(input);
  const LaneMask is_free = is_prepared & stored.is_short() & is_same_momentum(L_B, found_L_B);
  const LaneMask is_long = is_prepared & !stored.is_short();

  LaneMask is_taken = is_free;
  Turned turned;
  if (any(is_free)) {
    const FreeSteps free(stored, axes, L_B, found_L_B, state);
    turned = free.turned;
    const LaneRows<double> next_L = {free.next_L[0], free.next_L[1], free.next_L[2]};
    if (all(is_free)) {
      store_rows_of_three(next_L, [&](std::size_t lane) { return steps[lane]->L.data(); });
    } else {
      const std::bitset<kLanes> free_lanes = is_free.bits();
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (free_lanes[lane]) steps[lane]->L = {next_L.x[lane], next_L.y[lane], next_L.z[lane]};
      }
    }
  }
  if (!all(is_free | is_long)) {
    const ChangedSteps changed(input, state, ChangedSteps::kicked_L_W(input, state));
    const LaneMask is_changed = changed.made.is_good & !is_free & !is_long;
    changed.made.steps.store(steps, is_changed.bits());
    turned = any(is_free) ? select(is_changed, changed.turned, turned) : changed.turned;
    is_taken = is_free | is_changed;
  }
  left = ~is_taken.bits();
  if (left.all()) return;
  const LaneState end = end_of(turned, input.inertia_B);
  state = left.none() ? end : select(is_taken, end, state);
}

}  // namespace polhode::free_top
