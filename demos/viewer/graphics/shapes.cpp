#include "viewer/graphics/shapes.h"

#include <cmath>

namespace polhode::demos {

namespace {

using Vector3f = Eigen::Vector3f;

constexpr int kSlices = 32;
constexpr int kStacks = 20;
constexpr float kPi = 3.14159265f;

void add_quad(Triangles& triangles, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  for (const Vertex& vertex : {a, b, c, a, c, d}) triangles.push_back(vertex);
}

Vertex on_ball(int stack, int slice) {
  const float polar = kPi * static_cast<float>(stack) / kStacks;
  const float azimuth = 2.0f * kPi * static_cast<float>(slice) / kSlices;
  const Vector3f point(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                       std::cos(polar));
  return {point, point};
}

}  // namespace

Triangles cube() {
  Triangles triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const Vector3f normal = side * Vector3f::Unit(axis);
      const Vector3f u = Vector3f::Unit((axis + 1) % 3);
      const Vector3f v = Vector3f::Unit((axis + 2) % 3);
      add_quad(triangles, {normal - u - v, normal}, {normal + u - v, normal}, {normal + u + v, normal},
               {normal - u + v, normal});
    }
  }
  return triangles;
}

Triangles ball() {
  Triangles triangles;
  for (int stack = 0; stack < kStacks; ++stack) {
    for (int slice = 0; slice < kSlices; ++slice) {
      add_quad(triangles, on_ball(stack, slice), on_ball(stack + 1, slice), on_ball(stack + 1, slice + 1),
               on_ball(stack, slice + 1));
    }
  }
  return triangles;
}

Triangles cylinder(float top_radius) {
  Triangles triangles;
  const auto rim = [](int slice, float radius, float z) {
    const float angle = 2.0f * kPi * static_cast<float>(slice) / kSlices;
    return Vector3f(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int slice = 0; slice < kSlices; ++slice) {
    const Vector3f normal = rim(slice, 1.0f, 1.0f - top_radius).normalized();
    const Vector3f next_normal = rim(slice + 1, 1.0f, 1.0f - top_radius).normalized();
    add_quad(triangles, {rim(slice, 1.0f, 0.0f), normal}, {rim(slice + 1, 1.0f, 0.0f), next_normal},
             {rim(slice + 1, top_radius, 1.0f), next_normal}, {rim(slice, top_radius, 1.0f), normal});
    const Vector3f down = -Vector3f::UnitZ();
    for (const Vector3f& point : {Vector3f(0, 0, 0), rim(slice, 1.0f, 0.0f), rim(slice + 1, 1.0f, 0.0f)}) {
      triangles.push_back({point, down});
    }
  }
  return triangles;
}

Triangles square() {
  Triangles triangles;
  const Vector3f up = Vector3f::UnitZ();
  add_quad(triangles, {{-1, -1, 0}, up}, {{1, -1, 0}, up}, {{1, 1, 0}, up}, {{-1, 1, 0}, up});
  return triangles;
}

}  // namespace polhode::demos
