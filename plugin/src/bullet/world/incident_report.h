#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "bullet/world/body_group.h"
#include "polhode/bullet/incident.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Counts the incidents of a step, and calls the application's handler for the first one of each body and
/// kind.
class IncidentReport {
 public:
  /// Null if there is none. Shared, since the handler may replace itself while it runs.
  std::shared_ptr<const IncidentHandler> handler;
  std::uint64_t count = 0;

  /// Call after all bodies have moved: the handler may release, reassign or remove bodies. follow_changes
  /// updates the groups to match the world, and is called after each call of the handler.
  void report(const std::array<BodyGroup*, 2>& groups, btDispatcher& dispatcher,
              const std::function<void()>& follow_changes);

 private:
  void count_incidents(BodyGroup& group, btDispatcher& dispatcher);
};

/// Removes the contacts of bodies that were not finite before the solve: they were detected at invalid poses.
void forget_contacts_of_sanitized(const BodyGroup& group, btDispatcher& dispatcher);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
