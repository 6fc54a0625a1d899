#include "viewer/model/camera.h"

#include <algorithm>
#include <cmath>

namespace polhode::demos {

namespace {

constexpr double kHalfFieldOfView = 0.35;   // rad
constexpr double kHighestElevation = 1.55;  // rad
constexpr double kZoomRange = 100.0;

}  // namespace

void OrbitCamera::look_at(const Vector3& target_W, double radius) {
  target_W_ = target_W;
  nominal_distance_ = radius / std::sin(kHalfFieldOfView);
  distance_ = nominal_distance_;
}

void OrbitCamera::orbit(double azimuth_rad, double elevation_rad) {
  azimuth_rad_ = std::remainder(azimuth_rad_ + azimuth_rad, 2.0 * M_PI);
  elevation_rad_ = std::clamp(elevation_rad_ + elevation_rad, -kHighestElevation, kHighestElevation);
}

void OrbitCamera::zoom(double factor) {
  distance_ = std::clamp(distance_ * factor, nominal_distance_ / kZoomRange, nominal_distance_ * kZoomRange);
}

Vector3 OrbitCamera::position_W() const {
  const Vector3 direction_W(std::cos(elevation_rad_) * std::cos(azimuth_rad_),
                            std::cos(elevation_rad_) * std::sin(azimuth_rad_), std::sin(elevation_rad_));
  return target_W_ + distance_ * direction_W;
}

Matrix4f OrbitCamera::view() const {
  const Vector3 back_W = (position_W() - target_W_).normalized();
  const Vector3 right_W = Vector3::UnitZ().cross(back_W).normalized();
  Matrix3 R_WC;
  R_WC << right_W, back_W.cross(right_W), back_W;
  Matrix4f result = Matrix4f::Identity();
  result.topLeftCorner<3, 3>() = R_WC.transpose().cast<float>();
  result.topRightCorner<3, 1>() = (-(R_WC.transpose() * position_W())).cast<float>();
  return result;
}

Matrix4f OrbitCamera::projection(double aspect) const {
  const double near_plane = 0.02 * distance_;
  const double far_plane = 200.0 * distance_;
  // The narrower side of the view gets the field of view, so that a tall view cuts nothing off.
  const double scale = std::min(aspect, 1.0) / std::tan(kHalfFieldOfView);
  Matrix4f result = Matrix4f::Zero();
  result(0, 0) = static_cast<float>(scale / aspect);
  result(1, 1) = static_cast<float>(scale);
  result(2, 2) = static_cast<float>((far_plane + near_plane) / (near_plane - far_plane));
  result(2, 3) = static_cast<float>(2.0 * far_plane * near_plane / (near_plane - far_plane));
  result(3, 2) = -1.0f;
  return result;
}

bool project(const Matrix4f& view_projection, const Vector3& point_W, const Eigen::Vector2f& size,
             Eigen::Vector2f& pixel) {
  const Eigen::Vector4f clip = view_projection * point_W.cast<float>().homogeneous();
  if (clip.w() <= 0.0f) return false;
  pixel.x() = (0.5f + 0.5f * clip.x() / clip.w()) * size.x();
  pixel.y() = (0.5f - 0.5f * clip.y() / clip.w()) * size.y();
  return true;
}

}  // namespace polhode::demos
