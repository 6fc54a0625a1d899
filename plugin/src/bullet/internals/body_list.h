#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <vector>

#include "polhode/bullet/precision.h"

class btRigidBody;

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Runs one of Bullet's loops for some of the world's bodies: temporarily shortens the world's list to them,
/// and restores the list in its order, which the solver depends on. `some` are positions in the list,
/// ascending. `loop` must not change the list.
template <class Loop>
void run_for(const std::vector<int>& some, btAlignedObjectArray<btRigidBody*>& bodies, const Loop& loop) {
  struct Shortened {
    const std::vector<int>& places;
    btAlignedObjectArray<btRigidBody*>& list;
    int size = list.size();

    ~Shortened() {
      list.resizeNoInitialize(size);
      for (std::size_t i = places.size(); i-- > 0;) list.swap(static_cast<int>(i), places[i]);
    }
  };
  Shortened put_back_at_end{some, bodies};
  // A body moves to the left or stays, so the positions in `some` that follow remain valid.
  for (std::size_t i = 0; i < some.size(); ++i) bodies.swap(static_cast<int>(i), some[i]);
  bodies.resizeNoInitialize(static_cast<int>(some.size()));
  loop();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
