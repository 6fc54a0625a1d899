#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__GNUC__)
// Compiled into whatever calls it, for the instruction set that the caller is compiled for.
#define POLHODE_INLINE inline __attribute__((always_inline))
#else
#define POLHODE_INLINE inline
#endif

/// What Lanes are made of: eight doubles, and eight masks that hold where they are not zero.
/// `apply(operation, result, a, ...)` is `operation(result, a, ...)` in each lane; `choose(result, masks, a,
/// b)` is `a` where the mask holds, else `b`. Either kind gives the same bits.
namespace polhode {

inline constexpr std::size_t kLanes = 8;

/// As wide as the numbers, as their comparisons give it.
template <class Number>
using LaneMaskOf = std::conditional_t<sizeof(Number) == sizeof(std::int64_t), std::int64_t, std::int32_t>;

#if defined(__GNUC__)
/// By the vector extensions of GCC and Clang, which do an operation in all the lanes. Vectors go by reference
/// only: code for different instruction sets would disagree on how to pass them.
template <class Scalar>
struct VectorRegistersOf {
  using Number = Scalar;
  typedef Number Values __attribute__((vector_size(kLanes * sizeof(Number))));
  typedef LaneMaskOf<Number> Masks __attribute__((vector_size(kLanes * sizeof(Number))));

  template <class Operation, class Result, class... Arguments>
  static POLHODE_INLINE void apply(Operation operation, Result& result, const Arguments&... arguments) {
    operation(result, arguments...);
  }

  // Bit by bit: the compilers do `masks ? a : b` one by one where there are less than eight in a register.
  static POLHODE_INLINE void choose(Values& result, const Masks& masks, const Values& a, const Values& b) {
    result = reinterpret_cast<Values>((reinterpret_cast<Masks>(a) & masks) |
                                      (reinterpret_cast<Masks>(b) & ~masks));
  }
};
#endif

/// In plain C++.
template <class Scalar>
struct PlainRegistersOf {
  using Number = Scalar;
  using Values = std::array<Number, kLanes>;
  using Masks = std::array<LaneMaskOf<Number>, kLanes>;

  template <class Operation, class Result, class... Arguments>
  static POLHODE_INLINE void apply(Operation operation, Result& result, const Arguments&... arguments) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) operation(result[lane], arguments[lane]...);
  }

  static POLHODE_INLINE void choose(Values& result, const Masks& masks, const Values& a, const Values& b) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) result[lane] = masks[lane] != 0 ? a[lane] : b[lane];
  }
};

#if defined(__GNUC__)
using VectorRegisters = VectorRegistersOf<double>;
#endif
using PlainRegisters = PlainRegistersOf<double>;

#if defined(__GNUC__) && !defined(POLHODE_PLAIN_LANES)
template <class Number>
using RegistersOf = VectorRegistersOf<Number>;
#else
template <class Number>
using RegistersOf = PlainRegistersOf<Number>;
#endif
using Registers = RegistersOf<double>;

}  // namespace polhode
