#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "bullet/world/body_registry.h"
#include "bullet/world/constrained_bodies.h"
#include "bullet/world/multibodies.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bodies of a world that step together: its rigid bodies, or the proxies of its multibodies.
struct BodyGroup {
  const Multibodies* multibodies;  ///< null for the world's rigid bodies
  BodyRegistry registry{};
  ConstrainedMarks is_constrained{};
  /// False for solvers that assume a symmetric inverse inertia, and for multibodies, whose solver computes
  /// its own.
  bool solver_takes_effective_inertia = false;

  /// Returns null for a rigid body.
  btMultiBody* multibody(std::size_t index) const {
    return multibodies == nullptr ? nullptr : &(*multibodies)[index].multibody();
  }
  /// Reads a multibody itself, since its proxy holds the value of the last step.
  bool is_static_or_kinematic(std::size_t index) const {
    if (multibodies == nullptr) return registry.bodies()[index]->isStaticOrKinematicObject();
    return multibody(index)->isBaseStaticOrKinematic();
  }
  /// Returns null for a multibody whose base has no collider.
  const btCollisionObject* collision_object(std::size_t index) const {
    if (multibodies == nullptr) return registry.bodies()[index];
    return multibody(index)->getBaseCollider();
  }
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
