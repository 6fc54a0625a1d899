#include "bullet/world/incident_report.h"

#include "bullet/body/non_finite.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr IncidentKind kKindsInOrder[kIncidentKinds] = {
    IncidentKind::non_finite_body, IncidentKind::scheme_diverged, IncidentKind::torque_law_failed};

void forget_contacts_of(const BodyGroup& group, std::size_t index, btDispatcher& dispatcher) {
  const btCollisionObject* const object = group.collision_object(index);
  if (object != nullptr) forget_contacts(dispatcher, *object);
}

void call_handler(BodyGroup& group, std::size_t index, IncidentKind kind, const IncidentHandler& handler,
                  const std::function<void()>& follow_changes) {
  const BodyRegistry::Lane place = group.registry.lane_at(index);
  if (place.batch == nullptr || group.registry.is_replaced(index)) return;
  LaneBits& to_report = place.batch->to_report[static_cast<std::size_t>(kind)];
  if (!to_report[place.lane]) return;
  to_report.reset(place.lane);
  place.batch->reported[static_cast<std::size_t>(kind)].set(place.lane);
  btMultiBody* const multibody = group.multibody(index);
  btRigidBody* const body = multibody == nullptr ? group.registry.bodies()[index] : nullptr;
  try {
    handler({kind, body, multibody, place.batch->steps[place.lane]});
  } catch (...) {  // Bullet's step is not exception-safe
  }
  // The handler may have removed or deleted bodies, or detached the plugin.
  follow_changes();
}

}  // namespace

std::string_view to_string(IncidentKind kind) {
  switch (kind) {
    case IncidentKind::scheme_diverged:
      return "scheme diverged";
    case IncidentKind::non_finite_body:
      return "non-finite body";
    case IncidentKind::torque_law_failed:
      break;
  }
  return "torque law failed";
}

void forget_contacts_of_sanitized(const BodyGroup& group, btDispatcher& dispatcher) {
  for (std::size_t i = 0; i < group.registry.bodies().size(); ++i) {
    const BodyRegistry::Lane place = group.registry.lane_at(i);
    if (place.batch != nullptr && place.batch->lanes_with_incident()[place.lane])
      forget_contacts_of(group, i, dispatcher);
  }
}

void IncidentReport::count_incidents(BodyGroup& group, btDispatcher& dispatcher) {
  for (std::size_t i = 0; i < group.registry.bodies().size(); ++i) {
    const BodyRegistry::Lane place = group.registry.lane_at(i);
    if (place.batch == nullptr) continue;
    for (const IncidentKind kind : kKindsInOrder) {
      LaneBits& to_report = place.batch->to_report[static_cast<std::size_t>(kind)];
      const LaneBits& reported = place.batch->reported[static_cast<std::size_t>(kind)];
      if (!to_report[place.lane]) continue;
      ++count;
      if (kind == IncidentKind::non_finite_body) forget_contacts_of(group, i, dispatcher);
      if (handler == nullptr || reported[place.lane]) to_report.reset(place.lane);
    }
  }
}

// Iterates over the bodies instead of a list of incidents, which would need memory.
void IncidentReport::report(const std::array<BodyGroup*, 2>& groups, btDispatcher& dispatcher,
                            const std::function<void()>& follow_changes) {
  for (BodyGroup* group : groups) count_incidents(*group, dispatcher);
  if (handler == nullptr) return;
  const std::shared_ptr<const IncidentHandler> present_handler = handler;
  const auto changes = [&groups] { return groups[0]->registry.changes() + groups[1]->registry.changes(); };
  for (BodyGroup* group : groups) {
    for (std::size_t i = 0; i < group->registry.bodies().size();) {
      const std::uint64_t before = changes();
      for (const IncidentKind kind : kKindsInOrder) {
        if (changes() == before) call_handler(*group, i, kind, *present_handler, follow_changes);
      }
      i = changes() == before ? i + 1 : 0;  // other bodies may have moved to earlier positions
    }
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
