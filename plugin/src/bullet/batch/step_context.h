#pragma once

#include <vector>

#include "bullet/batch/bullet_rows.h"
#include "bullet/internals/bullet_turn.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Who integrated the pose of a body after the solve.
enum class PoseIntegratedBy {
  bullet,   ///< Bullet's integrateTransforms: the library replaces its turn
  library,  ///< nobody yet, since Bullet's loop skipped the body: the library integrates the pose
};

/// Values that all bodies of a step share.
struct StepContext {
  btScalar dt;
  /// Marks of constrained bodies (constrained_bodies.h). Too short if memory ran out.
  const std::vector<char>& is_constrained;
  /// False for solvers that assume a symmetric inverse inertia.
  bool solver_takes_effective_inertia;
  double time_s;  ///< time passed to torque laws, at the start of the step
  /// Owned by this thread during the step.
  BulletTurn& bullet;
};

/// Returns true if Bullet's solver and integration move the body at present.
inline bool moves(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
