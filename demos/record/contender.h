#pragma once

#include <string>
#include <variant>
#include <vector>

#include "polhode/scheme_registry.h"
#include "scenario/scenario.h"

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

/// Returns every scheme, built in or registered, then Bullet's modes, then Bullet's multibody.
std::vector<Contender> all_contenders();

/// `exact`, the handout's four schemes, those that were registered, and Bullet's modes.
std::vector<Contender> default_contenders();

/// Returns the contenders of these names, in this order.
/// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or one given twice.
std::vector<Contender> find_contenders(const std::vector<std::string>& names);

/// Returns true if it takes rotors inside bodies.
bool takes_rotors(const Contender& contender);

/// @throws std::invalid_argument if the scenario has rotors and the contender takes none
void require_can_run(const Contender& contender, const Scenario& scenario);

struct ChosenContenders {
  std::vector<Contender> contenders;
  std::string note;  ///< says which were left out; one line, or empty
};

/// Returns those of them that can run the scenario.
ChosenContenders those_that_can_run(const std::vector<Contender>& contenders, const Scenario& scenario);

/// Returns the contenders of these names, or where none is named, those of the default ones that can run the scenario.
/// @throws std::invalid_argument as find_contenders and require_can_run
ChosenContenders chosen_contenders(const std::vector<std::string>& names, const Scenario& scenario);

}  // namespace polhode::demos
