#pragma once

namespace polhode::demos {

/// Compiles and links a pair of shaders. The caller deletes the program.
/// @throws std::runtime_error with the compiler's message
unsigned int make_shader_program(const char* vertex_source, const char* fragment_source);

}  // namespace polhode::demos
