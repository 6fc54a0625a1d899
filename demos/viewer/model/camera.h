#pragma once

#include <Eigen/Core>

#include "polhode/rotation_state.h"

namespace polhode::demos {

/// A column-major matrix, as OpenGL expects it.
using Matrix4f = Eigen::Matrix4f;

/// A camera on a sphere around a point of the world, with the world's z axis upwards.
class OrbitCamera {
 public:
  /// Moves the camera so that a ball of this radius around the target fills the view.
  void look_at(const Vector3& target_W, double radius);
  void move_to(const Vector3& target_W) { target_W_ = target_W; }

  /// Turns the camera around its target by these angles, rad. The elevation stays below that of the poles.
  void orbit(double azimuth_rad, double elevation_rad);
  /// Multiplies the distance, within limits.
  void zoom(double factor);

  Vector3 position_W() const;
  const Vector3& target_W() const { return target_W_; }
  double distance() const { return distance_; }
  Matrix4f view() const;
  Matrix4f projection(double aspect) const;

 private:
  Vector3 target_W_ = Vector3::Zero();
  double nominal_distance_ = 5.0;
  double distance_ = 5.0;
  double azimuth_rad_ = 0.9;
  double elevation_rad_ = 0.45;
};

/// Computes the position of a point in a viewport of this size, in pixels from its top left corner. Returns
/// false if the point is behind the camera.
bool project(const Matrix4f& view_projection, const Vector3& point_W, const Eigen::Vector2f& size,
             Eigen::Vector2f& pixel);

}  // namespace polhode::demos
