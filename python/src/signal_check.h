#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>

namespace polhode::python {

/// Lets Python look in on a run once in a while: Ctrl-C, and what else `also` does. Call without the GIL.
class SignalCheck {
 public:
  /// `also` is called with the GIL.
  explicit SignalCheck(std::function<void()> also = [] {}) : also_(std::move(also)) {}

  /// @throws pybind11::error_already_set, for Ctrl-C with a KeyboardInterrupt
  void operator()();

 private:
  std::function<void()> also_;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace polhode::python
