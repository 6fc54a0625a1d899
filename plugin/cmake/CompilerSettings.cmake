# Compile options of all targets of this project; not exported to its users.
add_library(polhode_compiler_settings INTERFACE)
if(MSVC)
  target_compile_options(polhode_compiler_settings INTERFACE /W4 $<$<BOOL:${POLHODE_WARNINGS_AS_ERRORS}>:/WX>)
else()
  # No contraction: the same bits with and without fused multiply-add. Clang warns about GoogleTest's macros.
  target_compile_options(polhode_compiler_settings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
    $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>
    -ffp-contract=off $<$<BOOL:${POLHODE_WARNINGS_AS_ERRORS}>:-Werror>)
  # Hides AVX and FMA from Eigen, which would otherwise use fused multiply-adds if the flags allow them. The compiler
  # still uses AVX, and POLHODE_REGISTER_BYTES tells the library.
  include(CheckCXXSymbolExists)
  check_cxx_symbol_exists(__AVX2__ "" POLHODE_FLAGS_ALLOW_AVX2)
  check_cxx_symbol_exists(__AVX512F__ "" POLHODE_FLAGS_ALLOW_AVX512)
  target_compile_options(polhode_compiler_settings INTERFACE -U__FMA__ -U__AVX__ -U__AVX2__ -U__AVX512F__)
  target_compile_definitions(polhode_compiler_settings INTERFACE
    POLHODE_REGISTER_BYTES=$<IF:$<BOOL:${POLHODE_FLAGS_ALLOW_AVX512}>,64,$<IF:$<BOOL:${POLHODE_FLAGS_ALLOW_AVX2}>,32,16>>)
endif()
