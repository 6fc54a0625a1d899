#pragma once

#include <LinearMath/btMatrix3x3.h>

#include <cstddef>

#include "bullet/bullet_replay.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// One body's turn. `result` may be `basis` itself.
struct BasisTurn {
  const btMatrix3x3* basis;
  const btVector3* omega_W;  // rad/s
  btMatrix3x3* result;
};

/// What Bullet's turn by omega_W over dt (s) makes of each basis, to the last bit what
/// btRigidBody::predictIntegratedTransform makes of it: for several bodies at once, or else by `replay`.
void turn_like_bullet(const BasisTurn* turns, std::size_t count, btScalar dt, BulletReplay& replay);

/// Whether turn_like_bullet takes several bodies at once: if that gives the bits of the Bullet that this
/// process runs. Found out at the first call, in some 0.1 ms, by a body of Bullet's: not while another thread
/// makes one.
bool turns_in_lanes();

}  // namespace POLHODE_PRECISION
}  // namespace polhode
