#pragma once

#include <array>
#include <vector>

#include "viewer/model/camera.h"
#include "viewer/model/palette.h"
#include "viewer/model/view_grid.h"

namespace polhode::demos {

enum class Mesh { cube, ball, cylinder, cone, square };

/// Draws shaded shapes and lines in viewports of a picture. Needs a current OpenGL 3.3 context during its
/// lifetime.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Clears the whole picture. The size is in the units of viewports, each of `scale` pixels.
  void clear(int width, int height, float scale);
  /// Directs drawing to this part of the picture, seen by this camera.
  void begin(const Rectangle& viewport, const OrbitCamera& camera);
  /// Directs drawing to the whole picture again.
  void end();
  /// `model_W` maps the shape's coordinates to the world's. Draw shapes with an opacity below 1 after those
  /// behind them.
  void draw(Mesh mesh, const Matrix4f& model_W, Color color, float opacity = 1.0f);
  /// Draws a line through all points.
  void draw_path(const std::vector<Eigen::Vector3f>& points_W, Color color);
  /// Draws a line from each even-numbered point to the next one.
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
