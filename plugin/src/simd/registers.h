#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__)
// Inlined into its caller, for the instruction set that the caller is compiled for.
#define POLHODE_INLINE inline __attribute__((always_inline))
#else
#define POLHODE_INLINE inline
#endif

#if defined(__has_builtin) && defined(__GNUC__) && !defined(POLHODE_PLAIN_WIDE)
#if __has_builtin(__builtin_shufflevector)
#define POLHODE_SHUFFLES
#endif
#endif

/// The storage of a Wide: eight numbers, and eight masks that are true if not zero. `apply(operation, result,
/// a, ...)` calls `operation(result, a, ...)` for each lane. `choose(result, masks, a, b)` takes `a` where
/// the mask is true, else `b`. `convert(result, values)` is static_cast from another precision. `bits(masks)`
/// has bit i set if mask i is true. `add_differences(result, a, b)` sets the bits in `result` in which the
/// numbers differ. VectorRegistersOf and PlainRegistersOf give the same bits.
namespace polhode {

inline constexpr std::size_t kLanes = 8;

/// An integer of the same size, the result of comparing vectors.
template <class Number>
using MaskNumberOf = std::conditional_t<sizeof(Number) == sizeof(std::int64_t), std::int64_t, std::int32_t>;

#if defined(__GNUC__)
/// Uses the vector extensions of GCC and Clang, whose operations act on all lanes. Passes vectors by
/// reference only, since code for different instruction sets would disagree on how to pass them by value.
template <class Scalar>
struct VectorRegistersOf {
  using Number = Scalar;
  typedef Number Values __attribute__((vector_size(kLanes * sizeof(Number))));
  typedef MaskNumberOf<Number> Masks __attribute__((vector_size(kLanes * sizeof(Number))));

  template <class Operation, class Result, class... Arguments>
  static POLHODE_INLINE void apply(Operation operation, Result& result, const Arguments&... arguments) {
    operation(result, arguments...);
  }

#if defined(POLHODE_SHUFFLES)
  // Compares in halves: GCC 12 compares vectors larger than one register number by number.
  template <class Comparison>
  static POLHODE_INLINE void compare(Comparison comparison, Masks& result, const Values& a, const Values& b) {
    typedef Number Half __attribute__((vector_size(kLanes / 2 * sizeof(Number))));
    typedef MaskNumberOf<Number> HalfMasks __attribute__((vector_size(kLanes / 2 * sizeof(Number))));
    const Half low_a = __builtin_shufflevector(a, a, 0, 1, 2, 3);
    const Half low_b = __builtin_shufflevector(b, b, 0, 1, 2, 3);
    const Half high_a = __builtin_shufflevector(a, a, 4, 5, 6, 7);
    const Half high_b = __builtin_shufflevector(b, b, 4, 5, 6, 7);
    HalfMasks low, high;
    comparison(low, low_a, low_b);
    comparison(high, high_a, high_b);
    result = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
#else
  template <class Comparison>
  static POLHODE_INLINE void compare(Comparison comparison, Masks& result, const Values& a, const Values& b) {
    comparison(result, a, b);
  }
#endif

  // Selects bit by bit: if a register holds fewer than eight numbers, compilers evaluate `masks ? a : b` one
  // by one.
  static POLHODE_INLINE void choose(Values& result, const Masks& masks, const Values& a, const Values& b) {
    result = reinterpret_cast<Values>((reinterpret_cast<Masks>(a) & masks) |
                                      (reinterpret_cast<Masks>(b) & ~masks));
  }

  static POLHODE_INLINE void add_differences(Masks& result, const Values& a, const Values& b) {
    result |= reinterpret_cast<Masks>(a) ^ reinterpret_cast<Masks>(b);
  }

  template <class Others>
  static POLHODE_INLINE void convert(Values& result, const Others& values) {
    result = __builtin_convertvector(values, Values);
  }

  // Combines the masks as vectors: if lanes were read one by one, compilers would also compare them one by
  // one.
  static POLHODE_INLINE unsigned bits(const Masks& masks) {
    const Masks all_bits = masks & Masks{1, 2, 4, 8, 16, 32, 64, 128};
#if defined(POLHODE_SHUFFLES)
    typedef MaskNumberOf<Number> Four __attribute__((vector_size(4 * sizeof(Number))));
    typedef MaskNumberOf<Number> Two __attribute__((vector_size(2 * sizeof(Number))));
    const Four four = __builtin_shufflevector(all_bits, all_bits, 0, 1, 2, 3) |
                      __builtin_shufflevector(all_bits, all_bits, 4, 5, 6, 7);
    const Two two = __builtin_shufflevector(four, four, 0, 1) | __builtin_shufflevector(four, four, 2, 3);
    return static_cast<unsigned>(two[0] | two[1]);
#else
    MaskNumberOf<Number> result = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result |= all_bits[lane];
    return static_cast<unsigned>(result);
#endif
  }
};
#endif

/// Uses plain C++.
template <class Scalar>
struct PlainRegistersOf {
  using Number = Scalar;
  using Values = std::array<Number, kLanes>;
  using Masks = std::array<MaskNumberOf<Number>, kLanes>;

  template <class Operation, class Result, class... Arguments>
  static POLHODE_INLINE void apply(Operation operation, Result& result, const Arguments&... arguments) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) operation(result[lane], arguments[lane]...);
  }

  template <class Comparison>
  static POLHODE_INLINE void compare(Comparison comparison, Masks& result, const Values& a, const Values& b) {
    apply(comparison, result, a, b);
  }

  static POLHODE_INLINE void choose(Values& result, const Masks& masks, const Values& a, const Values& b) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) result[lane] = masks[lane] != 0 ? a[lane] : b[lane];
  }

  static POLHODE_INLINE void add_differences(Masks& result, const Values& a, const Values& b) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      MaskNumberOf<Number> bits_a, bits_b;
      std::memcpy(&bits_a, &a[lane], sizeof bits_a);
      std::memcpy(&bits_b, &b[lane], sizeof bits_b);
      result[lane] |= bits_a ^ bits_b;
    }
  }

  static POLHODE_INLINE unsigned bits(const Masks& masks) {
    unsigned result = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result |= (masks[lane] != 0 ? 1U : 0U) << lane;
    return result;
  }

  template <class Others>
  static POLHODE_INLINE void convert(Values& result, const Others& values) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) result[lane] = static_cast<Number>(values[lane]);
  }
};

#if defined(__GNUC__)
using VectorRegisters = VectorRegistersOf<double>;
#endif
using PlainRegisters = PlainRegistersOf<double>;

#if defined(__GNUC__) && !defined(POLHODE_PLAIN_WIDE)
template <class Number>
using RegistersOf = VectorRegistersOf<Number>;
#else
template <class Number>
using RegistersOf = PlainRegistersOf<Number>;
#endif
using Registers = RegistersOf<double>;

}  // namespace polhode
