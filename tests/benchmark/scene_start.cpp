#include "benchmark/scene_start.h"

#include <LinearMath/btScalar.h>

#include <cmath>
#include <map>
#include <random>

#include "benchmark/scene_world.h"

namespace polhode::benchmarks {

namespace {

constexpr std::size_t kShapes = 64;
constexpr std::size_t kLayers = 5;
constexpr int kSettlingSteps = 240;
const btVector3 kPileHalfExtents(btScalar(0.5), btScalar(0.4), btScalar(0.3));

/// Does its own arithmetic instead of using std's distributions, so that every standard library makes the
/// same scene.
class Random {
 public:
  btScalar between(double lowest, double highest) {
    const double fraction = static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max());
    return static_cast<btScalar>(lowest + (highest - lowest) * fraction);
  }

  btVector3 direction() {
    const btScalar z = between(-1.0, 1.0);
    const btScalar angle = between(0.0, 2.0 * SIMD_PI);
    const btScalar r = btSqrt(1 - z * z);
    return {r * btCos(angle), r * btSin(angle), z};
  }

 private:
  std::mt19937 engine_{20181003};
};

std::size_t cells_along_an_edge(std::size_t count, double dimensions) {
  return static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(count), 1.0 / dimensions) - 1e-9));
}

btVector3 cell(std::size_t index, std::size_t edge) {
  const std::size_t row = index / edge % edge;
  const std::size_t layer = index / edge / edge;
  return {static_cast<btScalar>(index % edge), static_cast<btScalar>(row), static_cast<btScalar>(layer)};
}

SceneStart stacked_pile(std::size_t count) {
  SceneStart start;
  start.half_extents = {kPileHalfExtents};
  start.floor = true;
  start.gravity.setValue(0, 0, btScalar(-9.81));
  const std::size_t edge = cells_along_an_edge((count + kLayers - 1) / kLayers, 2.0);
  const btVector3 gap(btScalar(0.05), btScalar(0.05), btScalar(0.01));
  for (std::size_t i = 0; i < count; ++i) {
    const btVector3 place = cell(i, edge);
    // Each box rests on up to four others.
    const btScalar stagger = static_cast<std::size_t>(place.z()) % 2 == 0 ? btScalar(0) : btScalar(0.25);
    const btVector3 cells(place.x() + stagger, place.y() + stagger, place.z() + btScalar(0.5));
    const btTransform pose(btQuaternion::getIdentity(), cells * (kPileHalfExtents * 2 + gap));
    start.boxes.push_back({0, btScalar(1), pose, btVector3(0, 0, 0), btVector3(0, 0, 0)});
  }
  return start;
}

SceneStart settle(SceneStart start) {
  SceneWorld world(start, RotatedBy::bullet, nullptr);
  for (int i = 0; i < kSettlingSteps; ++i) world.step();
  for (std::size_t i = 0; i < start.boxes.size(); ++i) {
    start.boxes[i].pose = world.body(i).getWorldTransform();
    start.boxes[i].velocity_W = world.body(i).getLinearVelocity();
    start.boxes[i].omega_W = world.body(i).getAngularVelocity();
  }
  return start;
}

}  // namespace

// Boxes of 10 to 30 cm turn within the margin of Bullet's broadphase. With larger ones, updates of its tree
// would dominate the step on both sides.
SceneStart free_flight(std::size_t count) {
  Random random;
  SceneStart start;
  for (std::size_t i = 0; i < kShapes; ++i) {
    start.half_extents.emplace_back(random.between(0.05, 0.08), random.between(0.08, 0.11),
                                    random.between(0.11, 0.15));
  }
  const btScalar spacing = 1;
  const std::size_t edge = cells_along_an_edge(count, 3.0);
  for (std::size_t i = 0; i < count; ++i) {
    const btQuaternion q_WB(random.direction(), random.between(0.0, SIMD_PI));
    const btVector3 omega_W = random.direction() * (random.between(0.05, 0.15) / kTimeStep);
    start.boxes.push_back({i % kShapes, random.between(1.0, 3.0), btTransform(q_WB, cell(i, edge) * spacing),
                           btVector3(0, 0, 0), omega_W});
  }
  return start;
}

const SceneStart& settled_pile(std::size_t count) {
  static std::map<std::size_t, SceneStart> piles;
  const auto found = piles.find(count);
  if (found != piles.end()) return found->second;
  return piles.emplace(count, settle(stacked_pile(count))).first->second;
}

}  // namespace polhode::benchmarks
