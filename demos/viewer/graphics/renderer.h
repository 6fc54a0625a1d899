#pragma once

#include <array>
#include <vector>

#include "viewer/model/camera.h"
#include "viewer/model/palette.h"
#include "viewer/model/view_grid.h"

namespace polhode::demos {

enum class Mesh { cube, ball, cylinder, cone, square };

/// Draws shaded shapes and lines in viewports of a picture. Needs a current OpenGL 3.3 context all its life.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Clears the whole picture, of that size in the units of viewports; `scale` pixels are one of them.
  void clear(int width, int height, float scale);
  /// Draws from here on into that part of the picture, seen by that camera.
  void begin(const Rectangle& viewport, const OrbitCamera& camera);
  /// Draws into the whole picture again.
  void end();
  /// `model_W` takes the shape's coordinates to the world's. Below an opacity of 1 what is behind shows
  /// through: draw that first.
  void draw(Mesh mesh, const Matrix4f& model_W, Color color, float opacity = 1.0f);
  /// Draws lines from each point to the next.
  void draw_path(const std::vector<Eigen::Vector3f>& points_W, Color color);
  /// Draws lines from each point of even number to the next one.
  void draw_segments(const std::vector<Eigen::Vector3f>& points_W, Color color);

 private:
  static constexpr std::size_t kMeshes = 5;
  struct Buffer {
    unsigned int array = 0;
    unsigned int vertices = 0;
    int count = 0;
  };

  int pixels(float length) const;
  void set_color(Color color, float opacity, bool is_shaded);
  void draw_lines(const std::vector<Eigen::Vector3f>& points_W, Color color, unsigned int how);

  unsigned int program_ = 0;
  std::array<Buffer, kMeshes> meshes_;
  Buffer lines_;
  float picture_height_ = 0.0f;
  float scale_ = 1.0f;
  Matrix4f view_projection_ = Matrix4f::Identity();
};

}  // namespace polhode::demos
