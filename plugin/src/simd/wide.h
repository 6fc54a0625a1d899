#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <bitset>
#include <cmath>

#include "simd/lane_bits.h"
#include "simd/registers.h"

/// One number for each of eight bodies, with vector arithmetic. Each lane has the same bits as plain
/// arithmetic, on every instruction set: only operations that IEEE 754 rounds correctly are vectorized, and
/// the compiler must not contract them.
///
/// BasicWide is a scalar type for Eigen: Vector3Wide, Matrix3Wide and QuaternionWide below are used like
/// their double counterparts. `select` replaces branches.
namespace polhode {

/// A boolean for each lane.
template <class Registers>
class alignas(kLanes * sizeof(typename Registers::Number)) BasicWideMask {
 public:
  using Masks = typename Registers::Masks;

  BasicWideMask() = default;
  // User-defined, so that every compiler passes it by address: code for different instruction sets would
  // disagree on how to pass it in registers.
  POLHODE_INLINE BasicWideMask(const BasicWideMask& other) : masks_(other.masks_) {}
  POLHODE_INLINE BasicWideMask& operator=(const BasicWideMask& other) {
    masks_ = other.masks_;
    return *this;
  }
  ~BasicWideMask() = default;

  template <class Operation, class... Arguments>
  static POLHODE_INLINE BasicWideMask of(Operation operation, const Arguments&... arguments) {
    BasicWideMask result;
    Registers::apply(operation, result.masks_, arguments...);
    return result;
  }

  template <class Comparison, class Values>
  static POLHODE_INLINE BasicWideMask comparing(Comparison comparison, const Values& a, const Values& b) {
    BasicWideMask result;
    Registers::compare(comparison, result.masks_, a, b);
    return result;
  }

  /// Returns a mask that is true in the lanes whose bit is set.
  static POLHODE_INLINE BasicWideMask from_bits(const std::bitset<kLanes>& bits) {
    BasicWideMask result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result.masks_[lane] = bits[lane] ? -1 : 0;
    return result;
  }

  POLHODE_INLINE const Masks& masks() const { return masks_; }
  POLHODE_INLINE std::bitset<kLanes> bits() const { return Registers::bits(masks_); }
  POLHODE_INLINE LaneBits lanes() const { return LaneBits(Registers::bits(masks_)); }
  bool operator[](std::size_t lane) const { return lanes()[lane]; }

  friend POLHODE_INLINE BasicWideMask operator&(const BasicWideMask& a, const BasicWideMask& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x & y; }, a.masks_, b.masks_);
  }
  friend POLHODE_INLINE BasicWideMask operator|(const BasicWideMask& a, const BasicWideMask& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x | y; }, a.masks_, b.masks_);
  }
  friend POLHODE_INLINE BasicWideMask operator!(const BasicWideMask& a) {
    return of([](auto& result, const auto& x) { result = x == 0; }, a.masks_);
  }

  friend POLHODE_INLINE bool any(const BasicWideMask& a) { return Registers::bits(a.masks_) != 0; }
  friend POLHODE_INLINE bool all(const BasicWideMask& a) {
    return Registers::bits(a.masks_) == (1U << kLanes) - 1;
  }

 private:
  Masks masks_;
};

/// Aligned for the widest instruction set. Otherwise GCC would choose the alignment by the instruction set it
/// compiles for, and rely on it in a function compiled for another.
template <class Registers>
class alignas(kLanes * sizeof(typename Registers::Number)) BasicWide {
 public:
  using Number = typename Registers::Number;
  using Values = typename Registers::Values;
  using Mask = BasicWideMask<Registers>;

  BasicWide() = default;
  POLHODE_INLINE BasicWide(const BasicWide& other) : values_(other.values_) {}
  // Implicit, since numbers in formulas are plain. NOLINTNEXTLINE(google-explicit-constructor)
  POLHODE_INLINE BasicWide(Number same) {
    Registers::apply([same](auto& result) { result = same - decltype(result + result){}; }, values_);
  }
  POLHODE_INLINE explicit BasicWide(const Values& values) : values_(values) {}
  POLHODE_INLINE BasicWide& operator=(const BasicWide& other) {
    values_ = other.values_;
    return *this;
  }
  ~BasicWide() = default;

  POLHODE_INLINE const Values& values() const { return values_; }
  POLHODE_INLINE Number operator[](std::size_t lane) const { return values_[lane]; }
  POLHODE_INLINE void set(std::size_t lane, Number value) { values_[lane] = value; }

  friend POLHODE_INLINE BasicWide operator+(const BasicWide& a, const BasicWide& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x + y; }, a, b);
  }
  friend POLHODE_INLINE BasicWide operator-(const BasicWide& a, const BasicWide& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x - y; }, a, b);
  }
  friend POLHODE_INLINE BasicWide operator*(const BasicWide& a, const BasicWide& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x * y; }, a, b);
  }
  friend POLHODE_INLINE BasicWide operator/(const BasicWide& a, const BasicWide& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x / y; }, a, b);
  }
  friend POLHODE_INLINE BasicWide operator-(const BasicWide& a) {
    return of([](auto& result, const auto& x) { result = -x; }, a);
  }
  POLHODE_INLINE BasicWide& operator+=(const BasicWide& b) { return *this = *this + b; }
  POLHODE_INLINE BasicWide& operator-=(const BasicWide& b) { return *this = *this - b; }
  POLHODE_INLINE BasicWide& operator*=(const BasicWide& b) { return *this = *this * b; }
  POLHODE_INLINE BasicWide& operator/=(const BasicWide& b) { return *this = *this / b; }

  friend POLHODE_INLINE Mask operator<(const BasicWide& a, const BasicWide& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x < y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator<=(const BasicWide& a, const BasicWide& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x <= y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator==(const BasicWide& a, const BasicWide& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x == y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator>(const BasicWide& a, const BasicWide& b) { return b < a; }
  friend POLHODE_INLINE Mask operator>=(const BasicWide& a, const BasicWide& b) { return b <= a; }
  friend POLHODE_INLINE Mask operator!=(const BasicWide& a, const BasicWide& b) { return !(a == b); }

  /// Returns `a` in the lanes where the mask is true, `b` in the others.
  friend POLHODE_INLINE BasicWide select(const Mask& mask, const BasicWide& a, const BasicWide& b) {
    BasicWide result;
    Registers::choose(result.values_, mask.masks(), a.values_, b.values_);
    return result;
  }

  /// Converts from another precision, with the rounding of static_cast.
  template <class Others>
  static POLHODE_INLINE BasicWide converted(const BasicWide<Others>& others) {
    BasicWide result;
    Registers::convert(result.values_, others.values());
    return result;
  }

  /// Calls a function of one number for each lane.
  template <class Function>
  friend POLHODE_INLINE BasicWide in_each_lane(const BasicWide& a, Function function) {
    BasicWide result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result.set(lane, function(a[lane]));
    return result;
  }

  // Found by argument-dependent lookup where formulas name the std:: functions of plain numbers.
  friend POLHODE_INLINE BasicWide sqrt(const BasicWide& a) {
    return in_each_lane(a, [](Number x) { return std::sqrt(x); });
  }
  friend POLHODE_INLINE BasicWide abs(const BasicWide& a) {
    return in_each_lane(a, [](Number x) { return std::abs(x); });
  }
  friend POLHODE_INLINE BasicWide min(const BasicWide& a, const BasicWide& b) { return select(b < a, b, a); }
  friend POLHODE_INLINE BasicWide max(const BasicWide& a, const BasicWide& b) { return select(a < b, b, a); }

 private:
  template <class Operation, class... Arguments>
  static POLHODE_INLINE BasicWide of(Operation operation, const Arguments&... arguments) {
    BasicWide result;
    Registers::apply(operation, result.values_, arguments.values_...);
    return result;
  }

  Values values_;
};

/// Finds lanes in which numbers differ in any bit. Takes one comparison for any number of pairs.
template <class Registers>
class BasicWideDifferences {
 public:
  POLHODE_INLINE void add(const BasicWide<Registers>& a, const BasicWide<Registers>& b) {
    Registers::add_differences(differences_, a.values(), b.values());
  }
  POLHODE_INLINE BasicWideMask<Registers> are_none() const {
    return BasicWideMask<Registers>::of([](auto& result, const auto& x) { result = x == 0; }, differences_);
  }

 private:
  typename Registers::Masks differences_ = {};
};

using Wide = BasicWide<Registers>;
using WideMask = BasicWideMask<Registers>;
using WideDifferences = BasicWideDifferences<Registers>;
using Vector3Wide = Eigen::Matrix<Wide, 3, 1>;
using Matrix3Wide = Eigen::Matrix<Wide, 3, 3>;
using QuaternionWide = Eigen::Quaternion<Wide, Eigen::DontAlign>;

/// `select` and `all` for plain numbers, for formulas written for both double and Wide.
POLHODE_INLINE double select(bool condition, double a, double b) {
  return condition ? a : b;
}
POLHODE_INLINE bool all(bool condition) {
  return condition;
}

/// Selects whole matrices, for both double and Wide.
template <class Mask, class Scalar, int rows, int columns, int options>
POLHODE_INLINE auto select(const Mask& mask, const Eigen::Matrix<Scalar, rows, columns, options>& a,
                           const Eigen::Matrix<Scalar, rows, columns, options>& b) {
  Eigen::Matrix<Scalar, rows, columns, options> result;
  for (int i = 0; i < rows * columns; ++i) result.coeffRef(i) = select(mask, a.coeff(i), b.coeff(i));
  return result;
}

}  // namespace polhode

namespace Eigen {

template <class Registers>
struct NumTraits<polhode::BasicWide<Registers>> : GenericNumTraits<polhode::BasicWide<Registers>> {
  using Real = polhode::BasicWide<Registers>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  // NOLINTEND(readability-identifier-naming)
};

// For expressions like 2.0 * vector.
template <class Registers, class Operation>
struct ScalarBinaryOpTraits<double, polhode::BasicWide<Registers>, Operation> {
  using ReturnType = polhode::BasicWide<Registers>;
};
template <class Registers, class Operation>
struct ScalarBinaryOpTraits<polhode::BasicWide<Registers>, double, Operation> {
  using ReturnType = polhode::BasicWide<Registers>;
};

// Eigen would ask for less alignment than that of Wide, which Clang rejects.
template <class Registers, int size>
struct internal::compute_default_alignment<polhode::BasicWide<Registers>, size> {
  enum { value = 0 };
};

}  // namespace Eigen
