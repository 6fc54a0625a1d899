#include "run/adapter/rotated_worlds.h"

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <exception>
#include <stdexcept>
#include <typeinfo>
#include <utility>

#include "run/adapter/type_names.h"

namespace polhode::run {

namespace {

// Uses the public interface: setting a scheme throws if the world is gone.
bool is_world_gone(RotationPlugin& plugin, const std::string& scheme) {
  try {
    plugin.rotation().set_default_scheme(scheme);
    return false;
  } catch (const std::logic_error&) {
    return true;
  }
}

}  // namespace

bool RotatedWorlds::before_step(btDynamicsWorld& world) noexcept {
  try {
    const std::lock_guard<std::mutex> lock(mutex_);
    RotatedWorld& seen = worlds_[&world];
    see(seen, world);
    if (seen.plugin == nullptr) return false;
    count_bodies(seen);
    return true;
  } catch (const std::exception&) {  // out of memory: the next step tries again
    return false;
  }
}

void RotatedWorlds::see(RotatedWorld& seen, btDynamicsWorld& world) {
  if (seen.plugin != nullptr) {
    if (seen.plugin->attached()) return;
    if (!is_world_gone(*seen.plugin, scheme_)) {
      // Leaked, since its destructor would access an island manager that the program may have destroyed.
      static_cast<void>(seen.plugin.release());
      leave_to_bullet(world, "the program has replaced the world's island manager");
      return;
    }
    seen = RotatedWorld();
  }
  const bool is_known = seen.type_name == typeid(world).name() && seen.dispatcher == world.getDispatcher();
  if (!is_known) attach(seen, world);
}

void RotatedWorlds::attach(RotatedWorld& seen, btDynamicsWorld& world) {
  seen = RotatedWorld();
  try {
    if (is_rotated_by_the_program(world))
      throw std::invalid_argument("the program itself rotates the bodies of this world by polhode");
    seen.plugin = make_plugin(world);
    seen.with_multibodies = dynamic_cast<btMultiBodyDynamicsWorld*>(&world);
    ++counters_.rotated_worlds;
  } catch (const std::logic_error& refusal) {
    leave_to_bullet(world, refusal.what());
  }
  seen.type_name = typeid(world).name();
  seen.dispatcher = world.getDispatcher();
}

std::unique_ptr<RotationPlugin> RotatedWorlds::make_plugin(btDynamicsWorld& world) {
  auto plugin = std::make_unique<RotationPlugin>(world);
  plugin->rotation().set_default_scheme(scheme_);
  plugin->rotation().set_incident_handler([this](const Incident& incident) { counters_.count(incident); });
  return plugin;
}

// Reports each kind of world and reason once, since a program may create thousands of worlds.
void RotatedWorlds::leave_to_bullet(const btDynamicsWorld& world, const std::string& reason) {
  ++counters_.worlds_left_to_bullet;
  const std::string line = "a " + readable_type_name(world) + " is left to Bullet: " + reason;
  if (reported_.insert(line).second) report_(line.c_str());
}

void RotatedWorlds::count_bodies(const RotatedWorld& seen) {
  const RotationControl& rotation = seen.plugin->rotation();
  std::uint64_t multibodies = 0;
  const int count = seen.with_multibodies == nullptr ? 0 : seen.with_multibodies->getNumMultibodies();
  for (int i = 0; i < count; ++i)
    multibodies += rotation.manages(*seen.with_multibodies->getMultiBody(i)) ? 1 : 0;
  raise_to(counters_.most_multibodies, multibodies);
  raise_to(counters_.most_rigid_bodies, rotation.managed_bodies() - multibodies);
}

}  // namespace polhode::run
