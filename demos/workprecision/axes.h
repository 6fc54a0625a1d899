#pragma once

#include <cstdint>

/// The values that a map goes through, both ends included.
namespace polhode::demos {

/// Equally far apart in their logarithm.
struct LogarithmicAxis {
  double from;
  double to;
  std::int64_t count;

  double at(std::int64_t i) const;
};

/// Equally far apart.
struct LinearAxis {
  double from;
  double to;
  std::int64_t count;

  double at(std::int64_t i) const;
};

}  // namespace polhode::demos
