#include "viewer/graphics/shader.h"

#include <array>
#include <stdexcept>
#include <string>

#include "viewer/graphics/opengl.h"

namespace polhode::demos {

namespace {

unsigned int compile(GLenum kind, const char* source) {
  const unsigned int shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  int is_compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled == 0) {
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
    throw std::runtime_error(std::string("OpenGL refuses a shader: ") + log.data());
  }
  return shader;
}

}  // namespace

unsigned int make_shader_program(const char* vertex_source, const char* fragment_source) {
  const unsigned int program = glCreateProgram();
  for (const unsigned int shader :
       {compile(GL_VERTEX_SHADER, vertex_source), compile(GL_FRAGMENT_SHADER, fragment_source)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);  // deleted together with the program
  }
  glLinkProgram(program);
  int is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == 0) throw std::runtime_error("OpenGL cannot link the shaders");
  return program;
}

}  // namespace polhode::demos
