#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// That one RotationControl rotates the bodies of a world: two would each replace the other's turn.
class WorldClaim {
 public:
  WorldClaim() = default;
  ~WorldClaim() { give_up(); }
  WorldClaim(const WorldClaim&) = delete;
  WorldClaim& operator=(const WorldClaim&) = delete;

  /// @throws std::invalid_argument if another claim on this world stands.
  void stake(const btDynamicsWorld& world);
  void give_up() noexcept;

 private:
  const btDynamicsWorld* world_ = nullptr;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
