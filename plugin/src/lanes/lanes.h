#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <bitset>
#include <cmath>

#include "lanes/registers.h"

/// The same quantity of eight bodies, in arithmetic that a processor does on several at once. Each lane comes
/// out as in plain arithmetic, to the last bit, on every instruction set: only operations that IEEE
/// 754 rounds correctly are vectorised, and the compiler must not contract them.
///
/// A scalar of Eigen's: Vector3L, Matrix3L and QuaternionL below read like their namesakes in double. Instead
/// of a branch there is `select`.
namespace polhode {

/// A yes or no in each lane.
template <class Registers>
class alignas(kLanes * sizeof(typename Registers::Number)) BasicLaneMask {
 public:
  using Masks = typename Registers::Masks;

  BasicLaneMask() = default;
  // A copy constructor of its own makes every compiler pass it by address: in registers, code for different
  // instruction sets would disagree on which.
  POLHODE_INLINE BasicLaneMask(const BasicLaneMask& other) : masks_(other.masks_) {}
  POLHODE_INLINE BasicLaneMask& operator=(const BasicLaneMask& other) {
    masks_ = other.masks_;
    return *this;
  }
  ~BasicLaneMask() = default;

  template <class Operation, class... Arguments>
  static POLHODE_INLINE BasicLaneMask of(Operation operation, const Arguments&... arguments) {
    BasicLaneMask result;
    Registers::apply(operation, result.masks_, arguments...);
    return result;
  }

  template <class Comparison, class Values>
  static POLHODE_INLINE BasicLaneMask comparing(Comparison comparison, const Values& a, const Values& b) {
    BasicLaneMask result;
    Registers::compare(comparison, result.masks_, a, b);
    return result;
  }

  POLHODE_INLINE const Masks& masks() const { return masks_; }
  POLHODE_INLINE std::bitset<kLanes> bits() const { return Registers::bits(masks_); }
  bool operator[](std::size_t lane) const { return bits()[lane]; }

  friend POLHODE_INLINE BasicLaneMask operator&(const BasicLaneMask& a, const BasicLaneMask& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x & y; }, a.masks_, b.masks_);
  }
  friend POLHODE_INLINE BasicLaneMask operator|(const BasicLaneMask& a, const BasicLaneMask& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x | y; }, a.masks_, b.masks_);
  }
  friend POLHODE_INLINE BasicLaneMask operator!(const BasicLaneMask& a) {
    return of([](auto& result, const auto& x) { result = x == 0; }, a.masks_);
  }

  friend POLHODE_INLINE bool any(const BasicLaneMask& a) { return Registers::bits(a.masks_) != 0; }
  friend POLHODE_INLINE bool all(const BasicLaneMask& a) {
    return Registers::bits(a.masks_) == (1U << kLanes) - 1;
  }

 private:
  Masks masks_;
};

/// Aligned as the widest instruction set wants it: without being told so GCC aligns a vector for the set that
/// it compiles for, and would move it as aligned in a function compiled for another.
template <class Registers>
class alignas(kLanes * sizeof(typename Registers::Number)) BasicLanes {
 public:
  using Number = typename Registers::Number;
  using Values = typename Registers::Values;
  using Mask = BasicLaneMask<Registers>;

  BasicLanes() = default;
  POLHODE_INLINE BasicLanes(const BasicLanes& other) : values_(other.values_) {}
  // Numbers in formulas are plain. NOLINTNEXTLINE(google-explicit-constructor)
  POLHODE_INLINE BasicLanes(Number same) {
    Registers::apply([same](auto& result) { result = same - decltype(result + result){}; }, values_);
  }
  POLHODE_INLINE explicit BasicLanes(const Values& values) : values_(values) {}
  POLHODE_INLINE BasicLanes& operator=(const BasicLanes& other) {
    values_ = other.values_;
    return *this;
  }
  ~BasicLanes() = default;

  POLHODE_INLINE const Values& values() const { return values_; }
  POLHODE_INLINE Number operator[](std::size_t lane) const { return values_[lane]; }
  POLHODE_INLINE void set(std::size_t lane, Number value) { values_[lane] = value; }

  friend POLHODE_INLINE BasicLanes operator+(const BasicLanes& a, const BasicLanes& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x + y; }, a, b);
  }
  friend POLHODE_INLINE BasicLanes operator-(const BasicLanes& a, const BasicLanes& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x - y; }, a, b);
  }
  friend POLHODE_INLINE BasicLanes operator*(const BasicLanes& a, const BasicLanes& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x * y; }, a, b);
  }
  friend POLHODE_INLINE BasicLanes operator/(const BasicLanes& a, const BasicLanes& b) {
    return of([](auto& result, const auto& x, const auto& y) { result = x / y; }, a, b);
  }
  friend POLHODE_INLINE BasicLanes operator-(const BasicLanes& a) {
    return of([](auto& result, const auto& x) { result = -x; }, a);
  }
  POLHODE_INLINE BasicLanes& operator+=(const BasicLanes& b) { return *this = *this + b; }
  POLHODE_INLINE BasicLanes& operator-=(const BasicLanes& b) { return *this = *this - b; }
  POLHODE_INLINE BasicLanes& operator*=(const BasicLanes& b) { return *this = *this * b; }
  POLHODE_INLINE BasicLanes& operator/=(const BasicLanes& b) { return *this = *this / b; }

  friend POLHODE_INLINE Mask operator<(const BasicLanes& a, const BasicLanes& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x < y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator<=(const BasicLanes& a, const BasicLanes& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x <= y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator==(const BasicLanes& a, const BasicLanes& b) {
    return Mask::comparing([](auto& result, const auto& x, const auto& y) { result = x == y; }, a.values_,
                           b.values_);
  }
  friend POLHODE_INLINE Mask operator>(const BasicLanes& a, const BasicLanes& b) { return b < a; }
  friend POLHODE_INLINE Mask operator>=(const BasicLanes& a, const BasicLanes& b) { return b <= a; }
  friend POLHODE_INLINE Mask operator!=(const BasicLanes& a, const BasicLanes& b) { return !(a == b); }

  /// In each lane `a` where the mask holds, else `b`.
  friend POLHODE_INLINE BasicLanes select(const Mask& mask, const BasicLanes& a, const BasicLanes& b) {
    BasicLanes result;
    Registers::choose(result.values_, mask.masks(), a.values_, b.values_);
    return result;
  }

  /// From another precision, as static_cast rounds.
  template <class Others>
  static POLHODE_INLINE BasicLanes converted(const BasicLanes<Others>& others) {
    BasicLanes result;
    Registers::convert(result.values_, others.values());
    return result;
  }

  /// A function of one number, lane by lane.
  template <class Function>
  friend POLHODE_INLINE BasicLanes in_each_lane(const BasicLanes& a, Function function) {
    BasicLanes result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result.set(lane, function(a[lane]));
    return result;
  }

  // Found by argument-dependent lookup, where std:: names the function of a number.
  friend POLHODE_INLINE BasicLanes sqrt(const BasicLanes& a) {
    return in_each_lane(a, [](Number x) { return std::sqrt(x); });
  }
  friend POLHODE_INLINE BasicLanes abs(const BasicLanes& a) {
    return in_each_lane(a, [](Number x) { return std::abs(x); });
  }
  friend POLHODE_INLINE BasicLanes sin(const BasicLanes& a) {
    return in_each_lane(a, [](Number x) { return std::sin(x); });
  }
  friend POLHODE_INLINE BasicLanes cos(const BasicLanes& a) {
    return in_each_lane(a, [](Number x) { return std::cos(x); });
  }
  friend POLHODE_INLINE BasicLanes min(const BasicLanes& a, const BasicLanes& b) {
    return select(b < a, b, a);
  }
  friend POLHODE_INLINE BasicLanes max(const BasicLanes& a, const BasicLanes& b) {
    return select(a < b, b, a);
  }

 private:
  template <class Operation, class... Arguments>
  static POLHODE_INLINE BasicLanes of(Operation operation, const Arguments&... arguments) {
    BasicLanes result;
    Registers::apply(operation, result.values_, arguments.values_...);
    return result;
  }

  Values values_;
};

/// Whether numbers have the same bits, of any number of pairs at the cost of one comparison.
template <class Registers>
class BasicLaneDifferences {
 public:
  POLHODE_INLINE void add(const BasicLanes<Registers>& a, const BasicLanes<Registers>& b) {
    Registers::add_differences(differences_, a.values(), b.values());
  }
  POLHODE_INLINE BasicLaneMask<Registers> are_none() const {
    return BasicLaneMask<Registers>::of([](auto& result, const auto& x) { result = x == 0; }, differences_);
  }

 private:
  typename Registers::Masks differences_ = {};
};

using Lanes = BasicLanes<Registers>;
using LaneMask = BasicLaneMask<Registers>;
using LaneDifferences = BasicLaneDifferences<Registers>;
using Vector3L = Eigen::Matrix<Lanes, 3, 1>;
using Matrix3L = Eigen::Matrix<Lanes, 3, 3>;
using QuaternionL = Eigen::Quaternion<Lanes, Eigen::DontAlign>;

/// The same for plain numbers, for formulas written for both.
POLHODE_INLINE double select(bool condition, double a, double b) {
  return condition ? a : b;
}
POLHODE_INLINE bool all(bool condition) {
  return condition;
}

/// In all of a matrix, for either.
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
struct NumTraits<polhode::BasicLanes<Registers>> : GenericNumTraits<polhode::BasicLanes<Registers>> {
  using Real = polhode::BasicLanes<Registers>;
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

// 2.0 * vector and the like.
template <class Registers, class Operation>
struct ScalarBinaryOpTraits<double, polhode::BasicLanes<Registers>, Operation> {
  using ReturnType = polhode::BasicLanes<Registers>;
};
template <class Registers, class Operation>
struct ScalarBinaryOpTraits<polhode::BasicLanes<Registers>, double, Operation> {
  using ReturnType = polhode::BasicLanes<Registers>;
};

// The alignment of Lanes is more than the one Eigen would ask for, which Clang refuses.
template <class Registers, int size>
struct internal::compute_default_alignment<polhode::BasicLanes<Registers>, size> {
  enum { value = 0 };
};

}  // namespace Eigen
