#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/bullet/rotation_plugin.h"

namespace polhode::testing {

enum class Way { plain_bullet, rotation_world, rotation_plugin };

/// Selects the multithreaded parts of Bullet, in addition to the world's loops and one solver per island.
struct BulletParts {
  bool parallel_narrowphase;  ///< btCollisionDispatcherMt
  bool parallel_solver;       ///< btSequentialImpulseConstraintSolverMt for large islands
};

std::string to_string(Way way);
std::string to_string(BulletParts parts);

/// A btDiscreteDynamicsWorldMt with bodies. Bullet needs the scheduler to be set first.
class MtScene {
 public:
  MtScene(Way way, BulletParts parts);
  ~MtScene();
  MtScene(const MtScene&) = delete;
  MtScene& operator=(const MtScene&) = delete;

  btRigidBody& add(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                   btCollisionShape& shape);
  btCollisionShape& box(const btVector3& half_extents);

  btDiscreteDynamicsWorldMt& world() { return *world_; }
  const std::vector<std::unique_ptr<btRigidBody>>& bodies() const { return bodies_; }
  bool is_rotated() const { return rotation_ != nullptr; }
  /// Returns the control, which plain_bullet does not have.
  RotationControl& rotation() const { return *rotation_; }

  void step(btScalar dt);

  /// Returns a hash of every bit of all bodies: Bullet's data and, for managed bodies, the library's.
  std::uint64_t digest() const;

 private:
  btDefaultCollisionConfiguration configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  btDbvtBroadphase broadphase_;
  btConstraintSolverPoolMt solver_pool_;
  std::unique_ptr<btConstraintSolver> large_island_solver_;
  std::unique_ptr<btDiscreteDynamicsWorldMt> world_;
  std::optional<RotationPlugin> plugin_;
  RotationControl* rotation_ = nullptr;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace polhode::testing
