#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Ensures that at most one RotationControl is attached to a world.
class WorldClaim {
 public:
  WorldClaim() = default;
  ~WorldClaim() { release(); }
  WorldClaim(const WorldClaim&) = delete;
  WorldClaim& operator=(const WorldClaim&) = delete;

  /// @throws std::invalid_argument if another WorldClaim holds this world.
  void claim(const btDynamicsWorld& world);
  void release() noexcept;
  bool holds() const { return world_ != nullptr; }

 private:
  const btDynamicsWorld* world_ = nullptr;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
