#pragma once

#include <random>

namespace polhode::testing {

/// A number between low and high, the same everywhere: the standard fixes the numbers of a generator, but not
/// those of a distribution.
inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

}  // namespace polhode::testing
