#include "viewer/model/arrows.h"

#include <algorithm>
#include <cmath>

#include "world/body_shape.h"

namespace polhode::demos {

namespace {

constexpr double kAxisLength = 1.15;
constexpr double kOmegaLength = 1.6;
constexpr double kMomentumLength = 1.3;
constexpr double kGreatestLength = 2.2;

constexpr Color kAxisColors[] = {{0xB0, 0x30, 0x30}, {0x2E, 0x80, 0x2E}, {0x30, 0x48, 0xB8}};
constexpr Color kOmegaColor{0x10, 0x10, 0x10};
constexpr Color kMomentumColor{0xA0, 0x10, 0xA0};
constexpr Color kRotorColor{0xB0, 0x60, 0x00};

/// In radii, at the initial magnitude.
double length_of(const Vector3& vector_W, const Vector3& start_W, double usual) {
  const double norm = vector_W.norm();
  if (norm == 0.0) return 0.0;
  const double start_norm = start_W.norm();
  if (start_norm == 0.0) return usual;
  return std::min(usual * norm / start_norm, kGreatestLength);
}

}  // namespace

std::vector<Arrow> arrows_of(const Sample& sample, const Sample& start, double radius) {
  const Vector3& from_W = sample.position_W;
  const char* const axis_names[] = {"x", "y", "z"};
  std::vector<Arrow> arrows;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 axis_W = sample.state.q_WB * Vector3::Unit(axis);
    arrows.push_back({axis_names[axis], from_W, kAxisLength * radius * axis_W, kAxisColors[axis]});
  }
  const Vector3& omega_W = sample.state.omega_W;
  const Vector3& L_W = sample.state.L_W;
  arrows.push_back({"\u03c9", from_W,
                    length_of(omega_W, start.state.omega_W, kOmegaLength) * radius * omega_W.normalized(),
                    kOmegaColor});
  arrows.push_back({"L", from_W, length_of(L_W, start.state.L_W, kMomentumLength) * radius * L_W.normalized(),
                    kMomentumColor, 1.4});
  if (sample.state.has_rotor()) {
    const Vector3 h_W = sample.state.q_WB * sample.state.rotor_momentum_B;
    // On the scale of L, unless L is 0 at the start.
    const double length = length_of(h_W, start.state.L_W, kMomentumLength);
    arrows.push_back({"h", from_W, length * radius * h_W.normalized(), kRotorColor, 1.8});
  }
  return arrows;
}

double reach_of(const Body& body) {
  const DrawnBody drawn = drawn_body(body);
  double reach = drawn.radius.value_or(0.0);
  for (const DrawnBox& box : drawn.boxes) reach = std::max(reach, box.at_B.norm() + box.half_extents.norm());
  return reach;
}

}  // namespace polhode::demos
