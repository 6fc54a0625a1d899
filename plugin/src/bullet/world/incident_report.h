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

/// Counts the incidents of a step, and tells the application's handler of the first of each body and kind.
class IncidentReport {
 public:
  /// Shared, since it may be replaced while it runs. Null: none.
  std::shared_ptr<const IncidentHandler> handler;
  std::uint64_t count = 0;

  /// To be called when every body is done: the handler may release, reassign or remove bodies. follow_changes brings
  /// the groups in line with the world, and is called each time that the handler has run.
  void report(const std::array<BodyGroup*, 2>& groups, btDispatcher& dispatcher,
              const std::function<void()>& follow_changes);

 private:
  void count_incidents(BodyGroup& group, btDispatcher& dispatcher);
};

/// Forgets the contacts of bodies that were not finite before the solve: collision detection went by where they were.
void forget_contacts_of_sanitized(const BodyGroup& group, btDispatcher& dispatcher);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
