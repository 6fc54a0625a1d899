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

using StepBodiesFunction = void (*)(const BodyStep*, std::size_t) noexcept;

/// A built-in scheme that steps several bodies at once: its declaration and its function for any number of
/// them.
class LaneSchemeDefinition final : public RotationScheme {
 public:
  LaneSchemeDefinition(const SchemeDescription& description, StepBodiesFunction step_bodies_function)
      : description_(description), step_bodies_(step_bodies_function) {}

  SchemeDescription description() const noexcept override { return description_; }
  void step(const StepInput& input, RotationState& state) const noexcept override {
    SchemeMemory memory;
    step_with_memory(input, state, memory);
  }
  void step_with_memory(const StepInput& input, RotationState& state,
                        SchemeMemory& memory) const noexcept override {
    const BodyStep body{&input, &state, &memory};
    step_bodies_(&body, 1);
  }
  void step_bodies(const BodyStep* bodies, std::size_t count) const noexcept override {
    step_bodies_(bodies, count);
  }

 private:
  SchemeDescription description_;
  StepBodiesFunction step_bodies_;
};

// One accessor for each line of the list; the scheme's file defines it.
#define POLHODE_SCHEME(name) const RotationScheme& name();
#include "schemes/schemes.list"
#undef POLHODE_SCHEME

}  // namespace polhode::schemes
