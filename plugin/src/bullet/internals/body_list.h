#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <vector>

#include "polhode/bullet/precision.h"

class btRigidBody;

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Runs one of Bullet's loops over some of the world's bodies: shortens the world's list to them meanwhile,
/// and puts it back in its order, which the solver depends on. `loop` must not change the list.
template <class Loop>
void run_for(const std::vector<btRigidBody*>& some, btAlignedObjectArray<btRigidBody*>& bodies,
             const Loop& loop) {
  struct Shortened {
    btAlignedObjectArray<btRigidBody*>& list;
    int size = list.size();
    std::vector<btRigidBody*> replaced = {};

    ~Shortened() {
      list.resizeNoInitialize(size);
      for (std::size_t i = 0; i < replaced.size(); ++i) list[static_cast<int>(i)] = replaced[i];
    }
  };
  Shortened put_back_at_end{bodies};
  for (std::size_t i = 0; i < some.size(); ++i) {
    put_back_at_end.replaced.push_back(bodies[static_cast<int>(i)]);
    bodies[static_cast<int>(i)] = some[i];
  }
  bodies.resizeNoInitialize(static_cast<int>(some.size()));
  loop();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
