#pragma once

#include "lanes/lane_scheme.h"
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

using StepLanesFunction = void (*)(const LaneInput&, LaneState&) noexcept;

/// A built-in scheme that steps eight bodies at once and keeps nothing of them: its declaration and its step
/// function.
class LaneSchemeDefinition final : public LaneScheme {
 public:
  LaneSchemeDefinition(const SchemeDescription& description, StepLanesFunction step_function)
      : description_(description), step_(step_function) {}

  SchemeDescription description() const noexcept override { return description_; }
  void step_lanes(const LaneInput& input, LaneState& state,
                  const LaneMemories& /*memories*/) const noexcept override {
    step_(input, state);
  }

 private:
  SchemeDescription description_;
  StepLanesFunction step_;
};

// One accessor for each line of the list; the scheme's file defines it.
#define POLHODE_SCHEME(name) const RotationScheme& name();
#include "schemes/schemes.list"
#undef POLHODE_SCHEME

}  // namespace polhode::schemes
