#pragma once

#include "polhode/rotation_scheme.h"
#include "scheme_base/wide_scheme.h"
#include "simd/instruction_sets.h"

namespace polhode::schemes {

/// A built-in scheme that steps eight bodies at once without a memory. Compiles the formulas of its step and
/// its turn for each instruction set.
template <void (*step_formulas)(const WideStepInput&, WideState&),
          void (*turn_formulas)(const Vector3Wide& omega_W, const Wide& dt, WideState&)>
class WideSchemeDefinition final : public WideScheme {
 public:
  explicit WideSchemeDefinition(const SchemeDescription& description) : description_(description) {}

  SchemeDescription description() const noexcept override { return description_; }
  void step_wide(const WideStepInput& input, const WideMask& /*mask*/, WideState& state,
                 WideMemoryRow* /*memory*/) const noexcept override {
    step_eight(input, state);
  }
  void turn_wide(const Vector3Wide& omega_W, const Wide& dt, WideState& state) const noexcept override {
    turn_eight(omega_W, dt, state);
  }

 private:
  POLHODE_FOR_EACH_INSTRUCTION_SET
  static void step_eight(const WideStepInput& input, WideState& state) noexcept {
    step_formulas(input, state);
  }

  POLHODE_FOR_EACH_INSTRUCTION_SET
  static void turn_eight(const Vector3Wide& omega_W, const Wide& dt, WideState& state) noexcept {
    turn_formulas(omega_W, dt, state);
  }

  SchemeDescription description_;
};

// Declares one accessor for each line of the list; the scheme's file defines it.
#define POLHODE_SCHEME(name) const RotationScheme& name();
#include "schemes/schemes.list"
#undef POLHODE_SCHEME

}  // namespace polhode::schemes
