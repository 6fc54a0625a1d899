# What every target of this project is compiled with; not part of what it hands to its users.
add_library(polhode_compiler_settings INTERFACE)
if(MSVC)
  target_compile_options(polhode_compiler_settings INTERFACE /W4 $<$<BOOL:${POLHODE_WARNINGS_AS_ERRORS}>:/WX>)
else()
  # Contraction off: the same bits with and without fused multiply-add.
  target_compile_options(polhode_compiler_settings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
    -ffp-contract=off $<$<BOOL:${POLHODE_WARNINGS_AS_ERRORS}>:-Werror>)
endif()
