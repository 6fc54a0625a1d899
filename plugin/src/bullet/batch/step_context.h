#pragma once

#include <vector>

#include "bullet/batch/bullet_rows.h"
#include "bullet/internals/bullet_turn.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Tells who moved a body's pose after the solve.
enum class PoseIntegratedBy {
  bullet,   ///< Bullet's integrateTransforms: its turn is replaced
  library,  ///< nobody yet: Bullet's loop skipped the body
};

/// The values that all bodies of a step share.
struct StepContext {
  btScalar dt;
  /// 1 for a body with an enabled joint or a contact point, by btCollisionObject::getWorldArrayIndex. Too
  /// short if there was no memory for it.
  const std::vector<char>& is_constrained;
  /// False for solvers that assume a symmetric inverse inertia.
  bool solver_takes_effective_inertia;
  double time_s;  ///< at the start of the step, since the world's time began
  /// This thread's own.
  BulletTurn& bullet;
};

/// Returns whether Bullet's solver and integration move the body at present.
inline bool moves(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
