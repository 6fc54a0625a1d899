#pragma once

#include <cstddef>

/// Before a function: compiled once for each instruction set named, and the best that the processor has is
/// chosen when the program is loaded. All that the function calls is compiled into it. The bits are the same,
/// see wide.h. Elsewhere (another processor, system or compiler; ThreadSanitizer, which cannot run so early;
/// AddressSanitizer, with which GCC takes minutes for each; or where POLHODE_ONE_INSTRUCTION_SET is defined)
/// the function is compiled once, for what the compiler is told to use.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__) && !defined(POLHODE_ONE_INSTRUCTION_SET)
#define POLHODE_CLONES
#define POLHODE_FOR_EACH_INSTRUCTION_SET __attribute__((flatten, target_clones("avx512f", "avx2", "default")))
#elif defined(__GNUC__)
#define POLHODE_FOR_EACH_INSTRUCTION_SET __attribute__((flatten))
#else
#define POLHODE_FOR_EACH_INSTRUCTION_SET
#endif

namespace polhode {

/// Whether, in a function compiled for each instruction set, vectors of so many bytes are one register:
/// others are taken apart, number by number when they are shuffled.
inline bool is_one_register(std::size_t bytes) {
#if defined(POLHODE_CLONES)
  return bytes <= 16 || (bytes <= 32 && __builtin_cpu_supports("avx2")) ||
         (bytes <= 64 && __builtin_cpu_supports("avx512f"));
#elif defined(POLHODE_REGISTER_BYTES)
  return bytes <= POLHODE_REGISTER_BYTES;  // __AVX2__ and the like are hidden, see CompilerSettings.cmake
#else
  return bytes <= 16;
#endif
}

}  // namespace polhode
