#pragma once

#include <string>
#include <variant>
#include <vector>

#include "polhode/scheme_registry.h"

namespace polhode::demos {

/// Bullet's ways to treat the gyroscopic term, btRigidBodyFlags.
enum class BulletMode { none, explicit_force, implicit_world, implicit_body };

/// Bullet's other kind of body: each body is a btMultiBody without links in place of a btRigidBody.
struct BulletMultibody {};

/// Names what rotates the bodies of a run: one of the library's schemes, or Bullet itself in a world without
/// the library.
struct Contender {
  std::string name;
  std::string summary;
  std::variant<SchemePointer, BulletMode, BulletMultibody> method;
};

/// Returns every registered scheme, then Bullet's modes, then Bullet's multibody.
std::vector<Contender> all_contenders();

/// `exact`, the handout's four schemes and Bullet's modes.
std::vector<Contender> default_contenders();

/// Returns the contenders of these names, in this order.
/// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or one given twice.
std::vector<Contender> find_contenders(const std::vector<std::string>& names);

/// The same, or the default ones where none is named.
std::vector<Contender> chosen_contenders(const std::vector<std::string>& names);

}  // namespace polhode::demos
