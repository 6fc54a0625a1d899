#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scheme_base/wide_scheme.h"

namespace polhode::testing {

/// Eight bodies of a scheme, and the scheme's memory for them.
struct WideBatch {
  explicit WideBatch(const WideScheme& scheme) : memory(scheme.memory_rows(), Wide(0.0)) {}

  void put(std::size_t lane, const StepInput& its_input, const RotationState& its_state) {
    set_lane(lane, its_input, input);
    set_lane(lane, its_state, state);
  }

  RotationState state_of(std::size_t lane) const {
    RotationState result;
    get_lane(lane, state, result);
    return result;
  }

  std::vector<double> memory_of(std::size_t lane) const {
    std::vector<double> result;
    for (const WideMemoryRow& row : memory) result.push_back(row[lane]);
    return result;
  }

  void set_memory(std::size_t lane, const std::vector<double>& numbers) {
    for (std::size_t i = 0; i < memory.size(); ++i) memory[i].set(lane, numbers[i]);
  }

  WideStepInput input;
  WideState state;
  std::vector<WideMemoryRow> memory;
};

/// One body with the scheme's memory for it, if the scheme has a memory.
class RememberedBody {
 public:
  explicit RememberedBody(const RotationScheme& scheme)
      : scheme_(scheme), wide_scheme_(dynamic_cast<const WideScheme*>(&scheme)) {
    if (wide_scheme_ != nullptr) batch_.emplace(*wide_scheme_);
  }

  void step(const StepInput& input, RotationState& state) {
    if (wide_scheme_ == nullptr) {
      scheme_.step(input, state);
      return;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) batch_->put(lane, input, state);
    wide_scheme_->step_wide(batch_->input, WideMask::from_bits(1), batch_->state, batch_->memory.data());
    state = batch_->state_of(0);
  }

  void forget() { batch_->set_memory(0, std::vector<double>(batch_->memory.size(), 0.0)); }

 private:
  const RotationScheme& scheme_;
  const WideScheme* wide_scheme_;
  std::optional<WideBatch> batch_;
};

}  // namespace polhode::testing
