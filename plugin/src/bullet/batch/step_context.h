#pragma once

#include <vector>

#include "bullet/batch/bullet_rows.h"
#include "bullet/internals/bullet_turn.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Who moved a body's pose after the solve.
enum class PoseIntegratedBy {
  bullet,   ///< Bullet's integrateTransforms: its turn is replaced
  library,  ///< nobody yet: Bullet's loop skipped the body
};

/// What the bodies of a step have in common.
struct StepContext {
  btScalar dt;
  /// By btCollisionObject::getWorldArrayIndex: whether the body has an enabled joint or a contact point.
  const std::vector<char>& is_constrained;
  /// False for solvers that assume a symmetric inverse inertia.
  bool solver_takes_effective_inertia;
  /// Of this thread.
  BulletTurn& bullet;
};

/// Whether Bullet's solver and integration move the body at present.
inline bool moves(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
