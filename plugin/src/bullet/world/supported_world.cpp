#include "bullet/world/supported_world.h"

#include <stdexcept>
#include <string>

namespace polhode {
inline namespace POLHODE_PRECISION {

btDiscreteDynamicsWorld& require_supported(btDynamicsWorld& world) {
  const btDynamicsWorldType type = world.getWorldType();
  if (type == BT_DISCRETE_DYNAMICS_WORLD || type == BT_SOFT_RIGID_DYNAMICS_WORLD ||
      type == BT_SOFT_MULTIBODY_DYNAMICS_WORLD) {
    return static_cast<btDiscreteDynamicsWorld&>(world);
  }
  if (type == BT_DEFORMABLE_MULTIBODY_DYNAMICS_WORLD) {
    throw std::invalid_argument(
        "the bodies of a btDeformableMultiBodyDynamicsWorld cannot be rotated by a scheme, since its solver "
        "steps rigid and deformable bodies together: use another world for the rigid bodies, for example a "
        "btSoftMultiBodyDynamicsWorld");
  }
  throw std::invalid_argument(
      "the bodies of this kind of world cannot be rotated by a scheme (btDynamicsWorldType " +
      std::to_string(type) +
      "): valid are btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld, "
      "btMultiBodyDynamicsWorld, btSoftMultiBodyDynamicsWorld and classes derived from them");
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
