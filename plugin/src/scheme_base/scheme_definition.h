#pragma once

#include "polhode/rotation_math.h"
#include "polhode/rotation_scheme.h"
#include "scheme_base/wide_scheme.h"

namespace polhode::schemes {

using StepFunction = void (*)(const StepInput&, RotationState&) noexcept;

/// A built-in scheme that steps one body and turns by the exponential map: its declaration and its step
/// function.
class SchemeDefinition final : public RotationScheme {
 public:
  SchemeDefinition(const SchemeDescription& description, StepFunction step_function)
      : description_(description), step_(step_function) {}

  SchemeDescription description() const noexcept override { return description_; }
  void step(const StepInput& input, RotationState& state) const noexcept override { step_(input, state); }

 private:
  SchemeDescription description_;
  StepFunction step_;
};

using WideStepFunction = void (*)(const WideStepInput&, WideState&) noexcept;
using WideTurnFunction = void (*)(const Vector3Wide&, const Wide&, WideState&) noexcept;

/// A built-in scheme that steps eight bodies at once without a memory: its declaration, its step and its
/// turn.
class WideSchemeDefinition final : public WideScheme {
 public:
  WideSchemeDefinition(const SchemeDescription& description, WideStepFunction step_function,
                       WideTurnFunction turn_function)
      : description_(description), step_(step_function), turn_(turn_function) {}

  SchemeDescription description() const noexcept override { return description_; }
  void step_wide(const WideStepInput& input, const WideMask& /*mask*/, WideState& state,
                 WideMemoryRow* /*memory*/) const noexcept override {
    step_(input, state);
  }
  void turn_wide(const Vector3Wide& omega_W, const Wide& dt, WideState& state) const noexcept override {
    turn_(omega_W, dt, state);
  }

 private:
  SchemeDescription description_;
  WideStepFunction step_;
  WideTurnFunction turn_;
};

// One accessor for each line of the list; the scheme's file defines it.
#define POLHODE_SCHEME(name) const RotationScheme& name();
#include "schemes/schemes.list"
#undef POLHODE_SCHEME

}  // namespace polhode::schemes
