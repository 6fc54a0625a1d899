#pragma once

namespace polhode::demos {

/// A compiled and linked pair of shaders; the caller deletes the program.
/// @throws std::runtime_error with the compiler's words.
unsigned int make_shader_program(const char* vertex_source, const char* fragment_source);

}  // namespace polhode::demos
