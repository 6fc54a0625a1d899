#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <algorithm>
#include <vector>

#include "polhode/bullet/precision.h"

class btRigidBody;

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Temporarily shortens the world's body list so that one of Bullet's loops skips some bodies. The list is put
/// back in its order, which the solver depends on.
class HiddenBodies {
 public:
  using Bodies = btAlignedObjectArray<btRigidBody*>;

  /// Runs `loop` over `shown` alone, which are some of `bodies`. `loop` must not change the list.
  template <class Loop>
  void hide_all_but(const std::vector<btRigidBody*>& shown, Bodies& bodies, const Loop& loop) {
    all_.resize(static_cast<std::size_t>(bodies.size()));
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = bodies[static_cast<int>(i)];
    struct Shortened {
      HiddenBodies& hidden;
      Bodies& list;
      ~Shortened() { replace(hidden.all_, list); }
    };
    const Shortened put_back_at_end{*this, bodies};
    replace(shown, bodies);
    loop();
  }

 private:
  static void replace(const std::vector<btRigidBody*>& with, Bodies& bodies) {
    bodies.resizeNoInitialize(static_cast<int>(with.size()));
    if (!with.empty()) std::copy(with.begin(), with.end(), &bodies[0]);
  }

  std::vector<btRigidBody*> all_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
