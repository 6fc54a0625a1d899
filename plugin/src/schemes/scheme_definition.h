#pragma once

#include "polhode/rotation_math.h"
#include "polhode/rotation_scheme.h"

namespace polhode::schemes {

using StepFunction = void (*)(const StepInput&, RotationState&) noexcept;

/// A built-in scheme: its declaration and its step function.
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

// One accessor for each line of the list; the scheme's file defines it.
#define POLHODE_SCHEME(name) const RotationScheme& name();
#include "schemes/schemes.list"
#undef POLHODE_SCHEME

}  // namespace polhode::schemes
