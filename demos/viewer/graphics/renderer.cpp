#include "viewer/graphics/renderer.h"

#include <cmath>
#include <cstddef>

#include "viewer/graphics/opengl.h"
#include "viewer/graphics/shader.h"
#include "viewer/graphics/shapes.h"

namespace polhode::demos {

namespace {

// Lights shapes from the camera and from both sides, since the camera may be inside a swollen body.
constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model;
uniform mat4 view_projection;
uniform mat3 normal_matrix;
out vec3 normal_W;
out vec3 position_W;
out vec3 position_M;
void main() {
  vec4 world = model * vec4(position, 1.0);
  position_W = world.xyz;
  position_M = position;
  normal_W = normal_matrix * normal;
  gl_Position = view_projection * world;
})";

constexpr char kFragmentShader[] = R"(#version 330 core
in vec3 normal_W;
in vec3 position_W;
in vec3 position_M;
uniform bool has_octants;
uniform vec3 camera_W;
uniform vec4 color;
uniform bool is_shaded;
out vec4 result;
void main() {
  float light = 1.0;
  if (is_shaded) {
    vec3 n = normalize(normal_W);
    vec3 to_camera = normalize(camera_W - position_W);
    if (dot(n, to_camera) < 0.0) n = -n;
    vec3 to_lamp = normalize(to_camera + vec3(0.25, -0.35, 0.7));
    light = 0.5 + 0.55 * max(dot(n, to_lamp), 0.0);
  }
  if (has_octants && position_M.x * position_M.y * position_M.z < 0.0) light *= 0.7;
  result = vec4(min(color.rgb * light, vec3(1.0)), color.a);
})";

constexpr float kBackground[] = {0.96f, 0.96f, 0.95f};

template <typename Pointer>
Pointer offset(std::size_t bytes) {
  return reinterpret_cast<Pointer>(bytes);  // as OpenGL has it NOLINT(performance-no-int-to-ptr)
}

void upload(const void* data, std::size_t bytes, GLenum usage) {
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, usage);
}

}  // namespace

Renderer::Renderer() : program_(make_shader_program(kVertexShader, kFragmentShader)) {
  const Triangles shapes[kMeshes] = {cube(), ball(), cylinder(1.0f), cylinder(0.0f), square()};
  for (std::size_t mesh = 0; mesh < kMeshes; ++mesh) {
    Buffer& buffer = meshes_[mesh];
    glGenVertexArrays(1, &buffer.array);
    glGenBuffers(1, &buffer.vertices);
    glBindVertexArray(buffer.array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer.vertices);
    upload(shapes[mesh].data(), shapes[mesh].size() * sizeof(Vertex), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          offset<const void*>(offsetof(Vertex, position)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          offset<const void*>(offsetof(Vertex, normal)));
    buffer.count = static_cast<int>(shapes[mesh].size());
  }
  glGenVertexArrays(1, &lines_.array);
  glGenBuffers(1, &lines_.vertices);
  glBindVertexArray(lines_.array);
  glBindBuffer(GL_ARRAY_BUFFER, lines_.vertices);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), offset<const void*>(0));
}

Renderer::~Renderer() {
  for (Buffer& buffer : meshes_) {
    glDeleteVertexArrays(1, &buffer.array);
    glDeleteBuffers(1, &buffer.vertices);
  }
  glDeleteVertexArrays(1, &lines_.array);
  glDeleteBuffers(1, &lines_.vertices);
  glDeleteProgram(program_);
}

void Renderer::clear(int width, int height, float scale) {
  picture_height_ = static_cast<float>(height);
  scale_ = scale;
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glViewport(0, 0, pixels(static_cast<float>(width)), pixels(picture_height_));
  glClearColor(kBackground[0], kBackground[1], kBackground[2], 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

int Renderer::pixels(float length) const {
  return static_cast<int>(std::lround(scale_ * length));
}

void Renderer::begin(const Rectangle& viewport, const OrbitCamera& camera) {
  const int left = pixels(viewport.left);
  const int bottom = pixels(picture_height_ - viewport.top - viewport.height);
  const int width = pixels(viewport.left + viewport.width) - left;
  const int height = pixels(picture_height_ - viewport.top) - bottom;
  glViewport(left, bottom, width, height);
  glScissor(left, bottom, width, height);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_);
  view_projection_ = camera.projection(viewport.width / viewport.height) * camera.view();
  glUniformMatrix4fv(glGetUniformLocation(program_, "view_projection"), 1, GL_FALSE, view_projection_.data());
  const Eigen::Vector3f camera_W = camera.position_W().cast<float>();
  glUniform3fv(glGetUniformLocation(program_, "camera_W"), 1, camera_W.data());
}

void Renderer::end() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
}

void Renderer::draw(Mesh mesh, const Matrix4f& model_W, Color color, float opacity) {
  const Buffer& buffer = meshes_[static_cast<std::size_t>(mesh)];
  const Eigen::Matrix3f normal_matrix = model_W.topLeftCorner<3, 3>().inverse().transpose();
  glUniformMatrix4fv(glGetUniformLocation(program_, "model"), 1, GL_FALSE, model_W.data());
  glUniformMatrix3fv(glGetUniformLocation(program_, "normal_matrix"), 1, GL_FALSE, normal_matrix.data());
  set_color(color, opacity, true);
  // Without it the rotation of a ball would be invisible.
  const bool has_octants = mesh == Mesh::ball && opacity == 1.0f;
  glUniform1i(glGetUniformLocation(program_, "has_octants"), has_octants ? 1 : 0);
  glDepthMask(opacity < 1.0f ? GL_FALSE : GL_TRUE);
  glBindVertexArray(buffer.array);
  glDrawArrays(GL_TRIANGLES, 0, buffer.count);
  glDepthMask(GL_TRUE);
}

void Renderer::draw_path(const std::vector<Eigen::Vector3f>& points_W, Color color) {
  draw_lines(points_W, color, GL_LINE_STRIP);
}

void Renderer::draw_segments(const std::vector<Eigen::Vector3f>& points_W, Color color) {
  draw_lines(points_W, color, GL_LINES);
}

void Renderer::draw_lines(const std::vector<Eigen::Vector3f>& points_W, Color color, unsigned int how) {
  const Matrix4f identity = Matrix4f::Identity();
  glUniformMatrix4fv(glGetUniformLocation(program_, "model"), 1, GL_FALSE, identity.data());
  set_color(color, 1.0f, false);
  glUniform1i(glGetUniformLocation(program_, "has_octants"), 0);
  glBindVertexArray(lines_.array);
  glBindBuffer(GL_ARRAY_BUFFER, lines_.vertices);
  upload(points_W.data(), points_W.size() * sizeof(Eigen::Vector3f), GL_STREAM_DRAW);
  glDrawArrays(how, 0, static_cast<int>(points_W.size()));
}

void Renderer::set_color(Color color, float opacity, bool is_shaded) {
  glUniform4f(glGetUniformLocation(program_, "color"), static_cast<float>(color.red) / 255.0f,
              static_cast<float>(color.green) / 255.0f, static_cast<float>(color.blue) / 255.0f, opacity);
  glUniform1i(glGetUniformLocation(program_, "is_shaded"), is_shaded ? 1 : 0);
}

}  // namespace polhode::demos
