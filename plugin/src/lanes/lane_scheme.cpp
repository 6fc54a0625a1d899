#include "lanes/lane_scheme.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lanes/instruction_sets.h"
#include "lanes/lane_rows.h"

namespace polhode {

namespace {

// StepInput and RotationState are numbers one after the other, and so rows of four of them.
static_assert(offsetof(StepInput, torque_W) == 8 * sizeof(double), "the rows are no longer its members");
constexpr std::size_t kStateNumbers = 19;
static_assert(sizeof(RotationState) == kStateNumbers * sizeof(double), "the rows are no longer its members");

template <class Number>
using Pointers = std::array<Number*, kLanes>;

template <class Number>
POLHODE_INLINE auto row_at(const Pointers<Number>& numbers, std::size_t first) {
  return [&numbers, first](std::size_t lane) { return numbers[lane] + first; };
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void load(const Pointers<const double>& inputs, const Pointers<const double>& states, LaneInput& input,
          LaneState& state) noexcept {
  const auto input_0 = load_rows_of_four<double>(row_at(inputs, 0));
  const auto input_4 = load_rows_of_four<double>(row_at(inputs, 4));
  input.inertia_B = {input_0.x, input_0.y, input_0.z};
  input.delta_omega_W = {input_0.w, input_4.x, input_4.y};
  input.dt = input_4.z;
  input.turn_dt = input_4.w;
  const auto state_0 = load_rows_of_four<double>(row_at(states, 0));
  const auto state_4 = load_rows_of_four<double>(row_at(states, 4));
  const auto state_8 = load_rows_of_four<double>(row_at(states, 8));
  const auto state_12 = load_rows_of_four<double>(row_at(states, 12));
  const auto state_15 = load_rows_of_four<double>(row_at(states, 15));
  state.q_WB = {state_0.w, state_0.x, state_0.y, state_0.z};
  state.R_WB.col(0) = Vector3L(state_4.x, state_4.y, state_4.z);
  state.R_WB.col(1) = Vector3L(state_4.w, state_8.x, state_8.y);
  state.R_WB.col(2) = Vector3L(state_8.z, state_8.w, state_12.x);
  state.omega_W = {state_12.y, state_12.z, state_12.w};
  state.L_W = {state_15.y, state_15.z, state_15.w};
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void store(const LaneState& state, const Pointers<double>& states) noexcept {
  const auto store_row = [&](std::size_t first, const LaneRowsOfFour<double>& row) {
    store_rows_of_four(row, row_at(states, first));
  };
  const auto& q = state.q_WB.coeffs();
  const auto& R = state.R_WB;
  store_row(0, {q[0], q[1], q[2], q[3]});
  store_row(4, {R(0, 0), R(1, 0), R(2, 0), R(0, 1)});
  store_row(8, {R(1, 1), R(2, 1), R(0, 2), R(1, 2)});
  store_row(12, {R(2, 2), state.omega_W[0], state.omega_W[1], state.omega_W[2]});
  store_row(15, {state.omega_W[2], state.L_W[0], state.L_W[1], state.L_W[2]});
}

}  // namespace

void LaneScheme::step(const StepInput& input, RotationState& state) const noexcept {
  SchemeMemory memory;
  step_with_memory(input, state, memory);
}

void LaneScheme::step_with_memory(const StepInput& input, RotationState& state,
                                  SchemeMemory& memory) const noexcept {
  const BodyStep body{&input, &state, &memory};
  step_bodies(&body, 1);
}

void LaneScheme::step_bodies(const BodyStep* bodies, std::size_t count) const noexcept {
  for (std::size_t first = 0; first < count; first += kLanes) {
    step_block(bodies + first, std::min(kLanes, count - first));
  }
}

// Up to eight bodies; the last one fills the lanes that are left.
void LaneScheme::step_block(const BodyStep* bodies, std::size_t count) const noexcept {
  std::array<double, kStateNumbers> nobodys;
  Pointers<const double> inputs;
  Pointers<const double> starts;
  Pointers<double> ends;
  LaneMemories memories;
  memories.count = count;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const BodyStep& body = bodies[std::min(lane, count - 1)];
    inputs[lane] = reinterpret_cast<const double*>(body.input);
    starts[lane] = reinterpret_cast<const double*>(body.state);
    ends[lane] = lane < count ? reinterpret_cast<double*>(body.state) : nobodys.data();
    memories.of[lane] = body.memory;
  }
  LaneInput input;
  LaneState state;
  load(inputs, starts, input, state);
  step_lanes(input, state, memories);
  store(state, ends);
}

}  // namespace polhode
