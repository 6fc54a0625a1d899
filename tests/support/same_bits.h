#pragma once

#include <cstdint>
#include <cstring>

#include "polhode/rotation_state.h"

namespace polhode::testing {

/// Returns true if two doubles are bit-identical. Distinguishes +0 and -0; all NaNs are equal.
inline bool same_bits(double a, double b) {
  if (a != a) return b != b;
  std::uint64_t bits_of_a = 0;
  std::uint64_t bits_of_b = 0;
  std::memcpy(&bits_of_a, &a, sizeof a);
  std::memcpy(&bits_of_b, &b, sizeof b);
  return bits_of_a == bits_of_b;
}

template <class A, class B>
bool same_bits(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!same_bits(a.derived().coeff(i), b.derived().coeff(i))) return false;
  }
  return true;
}

inline bool same_bits(const RotationState& a, const RotationState& b) {
  return same_bits(a.q_WB.coeffs(), b.q_WB.coeffs()) && same_bits(a.R_WB.reshaped(), b.R_WB.reshaped()) &&
         same_bits(a.omega_W, b.omega_W) && same_bits(a.L_W, b.L_W) &&
         same_bits(a.rotor_momentum_B, b.rotor_momentum_B);
}

}  // namespace polhode::testing
