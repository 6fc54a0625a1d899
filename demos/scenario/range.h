#pragma once

#include <string>

namespace polhode::demos {

/// The valid values of a number, both ends included. Every number has such a range, so that none can overflow
/// Bullet's single precision.
struct Range {
  double lowest;
  double highest;

  constexpr bool contains(double value) const { return value >= lowest && value <= highest; }
};

/// A component of a vector of any unit.
inline constexpr Range kAnySign{-1e9, 1e9};
/// A coordinate of a position, m.
inline constexpr Range kPlace{-1e6, 1e6};

/// A component of a vector or quaternion that is normalized.
inline constexpr Range kAnyLength{-1e6, 1e6};
/// A principal moment of inertia, kg m^2.
inline constexpr Range kInertiaRange{1e-12, 1e9};

/// Returns for example "a finite number between 1e-06 and 1000".
std::string range_text(const Range& range);

}  // namespace polhode::demos
