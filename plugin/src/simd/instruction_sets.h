#pragma once

#include <cstddef>

/// Put before a function: compiles the function, with everything it calls, once for each instruction set
/// listed. The best one for the processor is chosen when the program is loaded. All give the same bits, see
/// wide.h. The function is compiled once, for the compiler's target, on other processors, systems and
/// compilers, with ThreadSanitizer (which cannot run that early), with AddressSanitizer (for which GCC takes
/// minutes for each instruction set), and if POLHODE_ONE_INSTRUCTION_SET is defined.
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

/// Returns true if a vector of this size fits one register, in a function compiled for each instruction set.
/// Larger vectors are split, and are shuffled number by number.
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
