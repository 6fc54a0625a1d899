#pragma once

#include <Eigen/Core>
#include <vector>

/// Triangles of simple shapes, with their normals.
namespace polhode::demos {

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
};

using Triangles = std::vector<Vertex>;

/// Returns a cube from -1 to 1 on each axis.
Triangles cube();
/// Returns a ball of radius 1.
Triangles ball();
/// Returns a cylinder of radius 1 along z from 0 to 1; a `top_radius` of 0 makes a cone.
Triangles cylinder(float top_radius);
/// Returns the plane z = 0 from -1 to 1.
Triangles square();

}  // namespace polhode::demos
