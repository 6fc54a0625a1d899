#pragma once

#include <random>

namespace polhode::testing {

/// Returns a number between low and high that is the same on every platform: the standard specifies the
/// output of generators, but not of distributions.
inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

}  // namespace polhode::testing
