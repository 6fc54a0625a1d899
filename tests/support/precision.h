#pragma once

#include <LinearMath/btScalar.h>

namespace polhode::testing {

inline constexpr bool kDoubleBullet = sizeof(btScalar) == sizeof(double);

/// Returns the tolerance for the precision that the test is compiled for.
constexpr double by_precision(double single_precision, double double_precision) {
  return kDoubleBullet ? double_precision : single_precision;
}

}  // namespace polhode::testing
