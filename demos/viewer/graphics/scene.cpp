#include "viewer/graphics/scene.h"

#include <algorithm>

#include "world/body_shape.h"

namespace polhode::demos {

namespace {

constexpr Color kOtherColor{0xA8, 0xA8, 0xA4};
constexpr Color kGroundColor{0xD8, 0xD8, 0xD2};
constexpr Color kGridColor{0xB4, 0xB4, 0xAE};
constexpr Color kPlaneColor{0xE6, 0xD8, 0xA8};
constexpr double kRoom = 1.7;        // around a body, for its arrows
constexpr double kSideBySide = 0.8;  // several bodies do not fill a ball
constexpr double kArrowThickness = 0.025;
constexpr double kEllipsoidSize = 1.45;
constexpr double kPlaneSize = 1.9;
constexpr std::int64_t kPathSteps = 3000;
/// The camera may be inside a body of more than this many times its volume, so such a body is drawn
/// transparent.
constexpr double kSwollen = 8.0;
constexpr float kSwollenOpacity = 0.3f;
constexpr int kGroundCells = 8;

Matrix4f affine(const Matrix3& linear, const Vector3& offset) {
  Matrix4f result = Matrix4f::Identity();
  result.topLeftCorner<3, 3>() = linear.cast<float>();
  result.topRightCorner<3, 1>() = offset.cast<float>();
  return result;
}

Matrix3 scaling(double x, double y, double z) {
  return Vector3(x, y, z).asDiagonal();
}

/// Returns the rotation from z to this direction.
Matrix3 turned_to(const Vector3& direction) {
  return Quaternion::FromTwoVectors(Vector3::UnitZ(), direction).toRotationMatrix();
}

void draw_body(Renderer& renderer, const DrawnBody& drawn, const Matrix3& R_WB, const Vector3& position_W,
               Color color, float opacity = 1.0f) {
  if (drawn.radius) {
    renderer.draw(Mesh::ball, affine(R_WB * *drawn.radius, position_W), color, opacity);
  }
  for (const DrawnBox& box : drawn.boxes) {
    const Matrix3 box_B = box.q_BP.toRotationMatrix() * box.half_extents.asDiagonal();
    renderer.draw(Mesh::cube, affine(R_WB * box_B, position_W + R_WB * box.at_B), color, opacity);
  }
}

void draw_arrow(Renderer& renderer, const Arrow& arrow, double thickness) {
  const double length = arrow.along_W.norm();
  if (length < thickness) return;
  const double head = std::min(5.0 * thickness, 0.5 * length);
  const Matrix3 R = turned_to(arrow.along_W);
  renderer.draw(Mesh::cylinder, affine(R * scaling(thickness, thickness, length - head), arrow.from_W),
                arrow.color);
  const Vector3 head_W = arrow.from_W + (1.0 - head / length) * arrow.along_W;
  renderer.draw(Mesh::cone, affine(R * scaling(2.4 * thickness, 2.4 * thickness, head), head_W), arrow.color);
}

std::vector<Eigen::Vector3f> moved(std::vector<Eigen::Vector3f> points_W, const Vector3& offset_W) {
  for (Eigen::Vector3f& point_W : points_W) point_W += offset_W.cast<float>();
  return points_W;
}

}  // namespace

Scene::Scene(const Simulation& simulation)
    : constraint_(simulation.scenario().constraint),
      centre_W_(simulation.scenario().body.position_W),
      reach_(reach_of(simulation.scenario().body)) {
  const Scenario& scenario = simulation.scenario();
  std::vector<const Body*> bodies = {&scenario.body};
  for (const Body& other : scenario.others) bodies.push_back(&other);
  Vector3 sum_W = Vector3::Zero();
  for (const Body* body : bodies) {
    drawn_.push_back(drawn_body(*body));
    sum_W += body->position_W;
  }
  centre_W_ = sum_W / static_cast<double>(bodies.size());
  radius_ = 0.0;
  for (const Body* body : bodies) {
    const double room = body == bodies.front() ? kRoom : 1.0;
    radius_ = std::max(radius_, (body->position_W - centre_W_).norm() + room * reach_of(*body));
  }
  if (bodies.size() > 1) radius_ *= kSideBySide;
}

void Scene::draw(Renderer& renderer, const Simulation& simulation, std::size_t index,
                 bool is_teaching) const {
  const Snapshot& snapshot = simulation.shown(index);
  if (simulation.scenario().ground) draw_ground(renderer, *simulation.scenario().ground);
  for (std::size_t other = 0; other < snapshot.others.size(); ++other) {
    const Pose& pose = snapshot.others[other];
    draw_body(renderer, drawn_[other + 1], pose.R_WB, pose.position_W, kOtherColor);
  }
  for (const Arrow& arrow : arrows(simulation, index, is_teaching)) {
    draw_arrow(renderer, arrow, arrow.thickness * kArrowThickness * reach_);
  }
  if (constraint_) draw_pivot(renderer, snapshot);
  const bool hides_all = snapshot.sample.det_R() > kSwollen;
  draw_body(renderer, drawn_.front(), snapshot.sample.state.R_WB, snapshot.sample.position_W,
            contender_color(index), hides_all ? kSwollenOpacity : 1.0f);
  if (is_teaching) draw_poinsot(renderer, simulation, index);
}

std::vector<Arrow> Scene::arrows(const Simulation& simulation, std::size_t index, bool is_teaching) const {
  const Sample& sample = simulation.shown(index).sample;
  std::vector<Arrow> arrows = arrows_of(sample, simulation.run(index).start(), reach_);
  const std::optional<Poinsot> poinsot_now = poinsot(simulation.run(index));
  // Has the ellipsoid's scale, so that it ends where the ellipsoid touches the plane.
  if (is_teaching && poinsot_now) arrows[3].along_W = poinsot_now->scale * sample.state.omega_W;
  return arrows;
}

void Scene::draw_ground(Renderer& renderer, const Ground& ground) const {
  const double size = 2.0 * radius_;
  const Vector3 foot_W = centre_W_ + (ground.height - ground.normal_W.dot(centre_W_)) * ground.normal_W;
  const Matrix3 R = turned_to(ground.normal_W);
  renderer.draw(Mesh::square, affine(R * scaling(size, size, 1.0), foot_W - 1e-3 * radius_ * ground.normal_W),
                kGroundColor);
  std::vector<Eigen::Vector3f> ends_W;
  for (int line = -kGroundCells; line <= kGroundCells; ++line) {
    const double at = size * line / kGroundCells;
    for (const Vector3& end :
         {Vector3(at, -size, 0), Vector3(at, size, 0), Vector3(-size, at, 0), Vector3(size, at, 0)}) {
      ends_W.emplace_back((foot_W + R * end).cast<float>());
    }
  }
  renderer.draw_segments(ends_W, kGridColor);
}

void Scene::draw_pivot(Renderer& renderer, const Snapshot& snapshot) const {
  const Sample& sample = snapshot.sample;
  const Vector3 pivot_W = sample.position_W + sample.state.q_WB * constraint_->pivot_B;
  const double size = 2.5 * kArrowThickness * reach_;
  renderer.draw(Mesh::ball, affine(scaling(size, size, size), pivot_W), {0, 0, 0});
}

void Scene::draw_poinsot(Renderer& renderer, const Simulation& simulation, std::size_t index) const {
  const ContenderRun& run = simulation.run(index);
  const std::optional<Poinsot> now = poinsot(run);
  if (!now) return;
  const Sample& sample = simulation.shown(index).sample;
  const Vector3& position_W = sample.position_W;
  const std::int64_t step = simulation.shown_step();
  renderer.draw_path(moved(polhode_path(run.history(), *now, step, kPathSteps), position_W), kPolhodeColor);
  renderer.draw_path(moved(herpolhode_path(run.history(), *now, step, kPathSteps), position_W),
                     kHerpolhodeColor);
  const double plane = kPlaneSize * reach_;
  renderer.draw(Mesh::square,
                affine(turned_to(now->normal_W) * scaling(plane, plane, 1.0),
                       position_W + now->distance * now->normal_W),
                kPlaneColor, 0.35f);
  const Matrix3 ellipsoid_W = sample.state.q_WB.toRotationMatrix() * now->half_axes_B.asDiagonal();
  renderer.draw(Mesh::ball, affine(ellipsoid_W, position_W), contender_color(index), 0.28f);
}

std::optional<Poinsot> Scene::poinsot(const ContenderRun& run) const {
  return poinsot_of(run.start(), run.inertia_B(), kEllipsoidSize * reach_);
}

}  // namespace polhode::demos
