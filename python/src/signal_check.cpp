#include "signal_check.h"

namespace polhode::python {

namespace {

constexpr std::chrono::milliseconds kBetweenChecks{50};

}  // namespace

void SignalCheck::operator()() {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + kBetweenChecks;
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  also_();
}

}  // namespace polhode::python
