#include "multithreading/run.h"

#include <algorithm>
#include <unordered_map>

namespace polhode::testing {

namespace {

std::unordered_map<const btRigidBody*, std::size_t> numbers_of(const MtScene& scene) {
  std::unordered_map<const btRigidBody*, std::size_t> numbers;
  for (std::size_t i = 0; i < scene.bodies().size(); ++i) numbers[scene.bodies()[i].get()] = i;
  return numbers;
}

}  // namespace

Outcome run(const Play& play, Way way, BulletParts parts, const SchedulerChoice& scheduler) {
  const ActiveScheduler active(scheduler.make());
  MtScene scene(way, parts);
  play.set_up(scene);
  Outcome result;
  int step = 1;
  const auto numbers = numbers_of(scene);
  if (way != Way::plain_bullet) {
    scene.rotation().set_incident_handler([&](const Incident& incident) {
      const std::size_t body = numbers.at(incident.body);
      result.incidents.push_back({step, incident.kind, body, incident.body_steps});
      result.threads_of_handler.insert(std::this_thread::get_id());
      if (incident.kind == IncidentKind::scheme_diverged && body % 2 == 0) {
        scene.rotation().set_scheme(*incident.body, "exact");
      }
    });
  }
  for (; step <= play.steps; ++step) {
    play.act(scene, step);
    scene.step(play.dt);
    result.digests.push_back(scene.digest());
  }
  if (way != Way::plain_bullet) result.counted_incidents = scene.rotation().incidents();
  result.contacts_at_end = scene.world().getDispatcher()->getNumManifolds();
  return result;
}

int first_step_that_differs(const Outcome& a, const Outcome& b) {
  const auto [in_a, in_b] =
      std::mismatch(a.digests.begin(), a.digests.end(), b.digests.begin(), b.digests.end());
  if (in_a == a.digests.end() && in_b == b.digests.end()) return 0;
  return static_cast<int>(in_a - a.digests.begin()) + 1;
}

}  // namespace polhode::testing
