#pragma once

#include <cstdint>

/// The values along an axis of a map, both ends included.
namespace polhode::demos {

/// Values with equal spacing of their logarithms.
struct LogarithmicAxis {
  double from;
  double to;
  std::int64_t count;

  double at(std::int64_t i) const;
};

/// Values with equal spacing.
struct LinearAxis {
  double from;
  double to;
  std::int64_t count;

  double at(std::int64_t i) const;
};

}  // namespace polhode::demos
