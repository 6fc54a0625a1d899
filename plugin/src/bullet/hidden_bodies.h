#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <vector>

#include "polhode/bullet/precision.h"

class btRigidBody;

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Lets a loop of Bullet's over the bodies of its world pass over some of them, by shortening the world's
/// list while the loop runs. The order in the list, which the solver goes by, is the same again afterwards.
class HiddenBodies {
 public:
  using Bodies = btAlignedObjectArray<btRigidBody*>;

  void hide_all_but(const std::vector<btRigidBody*>& shown, Bodies& bodies);
  void unhide(Bodies& bodies);

 private:
  std::vector<btRigidBody*> all_;  // in their order; empty while Bullet's own array still holds them
  int count_ = 0;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
