#include "run/adapter/type_names.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <cxxabi.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <typeinfo>

namespace polhode::run {

namespace {

// Mangled names contain the namespace polhode, a namespace for the precision, and the class.
bool names_class_of_polhode(const std::type_info& type, const char* name) {
  return std::strstr(type.name(), "7polhode") != nullptr && std::strstr(type.name(), name) != nullptr;
}

// Also searches the bases, since a program may derive from RotationWorld.
bool derives_from_rotation_world(const std::type_info& type) {
  if (names_class_of_polhode(type, "13RotationWorldI")) return true;
  if (const auto* with_base = dynamic_cast<const abi::__si_class_type_info*>(&type))
    return derives_from_rotation_world(*with_base->__base_type);
  const auto* with_bases = dynamic_cast<const abi::__vmi_class_type_info*>(&type);
  for (unsigned i = 0; with_bases != nullptr && i < with_bases->__base_count; ++i) {
    if (derives_from_rotation_world(*with_bases->__base_info[i].__base_type)) return true;
  }
  return false;
}

bool has_plugin(const btDynamicsWorld& world) {
  const auto* discrete = dynamic_cast<const btDiscreteDynamicsWorld*>(&world);
  if (discrete == nullptr) return false;
  const btSimulationIslandManager* manager = discrete->getSimulationIslandManager();
  return manager != nullptr && names_class_of_polhode(typeid(*manager), "ListeningManager");
}

}  // namespace

std::string readable_type_name(const btDynamicsWorld& world) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(typeid(world).name(), nullptr, nullptr, &status), std::free);
  return name == nullptr ? typeid(world).name() : name.get();
}

bool is_rotated_by_the_program(const btDynamicsWorld& world) {
  return derives_from_rotation_world(typeid(world)) || has_plugin(world);
}

}  // namespace polhode::run
