#pragma once

#include <cstdint>

#include "run/adapter/adapter.h"
#include "run/interposer/world_functions.h"

namespace polhode::run {

/// The rotation of worlds of one precision in this process.
class Rotation {
 public:
  explicit constexpr Rotation(const Precision& precision) : precision_(precision) {}

  /// Call before a world steps. Returns true if its bodies are rotated.
  bool before_step(void* world);
  void after_step(std::uint64_t substeps) const { adapter_->after_step(substeps); }

  const Precision& precision() const { return precision_; }
  Counts counts() const { return adapter_ == nullptr ? Counts() : adapter_->counts(); }
  /// Returns the number of calls of stepSimulation for which there was no adapter.
  std::uint64_t calls_left_alone() const { return calls_left_alone_; }

 private:
  void start(const void* function);

  const Precision& precision_;
  const void* rotated_function_ = nullptr;  // worlds that step by another function are left alone
  const Adapter* adapter_ = nullptr;
  std::uint64_t calls_left_alone_ = 0;
  bool is_started_ = false;
};

/// Returns the object for single precision (index 0) or double precision (index 1).
Rotation& rotation_in(int precision_index);

}  // namespace polhode::run
