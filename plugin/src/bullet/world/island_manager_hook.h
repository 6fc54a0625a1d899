#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What an island manager of ours tells.
class SolveListener {
 public:
  /// Collision detection is done, the solver comes next; once in each substep.
  virtual void before_solve() = 0;
  /// The world is being destroyed.
  virtual void world_dies() = 0;

 protected:
  ~SolveListener() = default;
};

/// Shows the start of a solve in a world that somebody else made: an island manager of ours takes the place
/// of the world's. Bullet calls its updateActivationState at that moment, and the world destroys it when it
/// dies. It is an island manager with the world's settings, so nobody who asks the world for it is misled.
class IslandManagerHook {
 public:
  /// @throws std::invalid_argument if the world's island manager is of a class of its own, which cannot be
  /// stood in for.
  IslandManagerHook(btDiscreteDynamicsWorld& world, SolveListener& listener);
  /// Puts the world's own back. If somebody has replaced ours meanwhile, theirs stays, and ours goes on as a
  /// plain one for whoever holds it.
  ~IslandManagerHook();
  IslandManagerHook(const IslandManagerHook&) = delete;
  IslandManagerHook& operator=(const IslandManagerHook&) = delete;

  /// False once somebody has replaced it.
  bool is_in_place() const;
  /// The world destroys its island manager: there is nothing left to put back.
  void world_is_gone() { own_ = nullptr; }

 private:
  btDiscreteDynamicsWorld& world_;
  btSimulationIslandManager* own_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
