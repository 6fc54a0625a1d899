#include "bullet/hidden_bodies.h"

#include <algorithm>

namespace polhode {
inline namespace POLHODE_PRECISION {

void HiddenBodies::hide_all_but(const std::vector<btRigidBody*>& shown, Bodies& bodies) {
  count_ = bodies.size();
  all_.clear();
  // With none shown the array keeps its pointers behind its end.
  if (!shown.empty()) {
    all_.assign(&bodies[0], &bodies[0] + count_);
    std::copy(shown.begin(), shown.end(), &bodies[0]);
  }
  bodies.resizeNoInitialize(static_cast<int>(shown.size()));
}

void HiddenBodies::unhide(Bodies& bodies) {
  bodies.resizeNoInitialize(count_);
  if (!all_.empty()) std::copy(all_.begin(), all_.end(), &bodies[0]);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
