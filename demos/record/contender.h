#pragma once

#include <string>
#include <variant>
#include <vector>

#include "polhode/scheme_registry.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// Bullet's treatments of the gyroscopic term, btRigidBodyFlags.
enum class BulletMode { none, explicit_force, implicit_world, implicit_body };

/// Bullet's other kind of body: a btMultiBody without links replaces each btRigidBody.
struct BulletMultibody {};

/// Names what rotates the bodies of a run: a scheme of the library, or Bullet in a world without the library.
struct Contender {
  std::string name;
  std::string summary;
  std::variant<SchemePointer, BulletMode, BulletMultibody> method;
};

/// Returns every scheme, built in or registered, then Bullet's modes, then Bullet's multibody.
std::vector<Contender> all_contenders();

/// Returns `exact`, the handout's four schemes, the schemes that were registered, and Bullet's modes.
std::vector<Contender> default_contenders();

/// Returns the contenders of these names, in this order.
/// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or a repeated one
std::vector<Contender> find_contenders(const std::vector<std::string>& names);

/// Returns true if the contender supports rotors inside bodies.
bool takes_rotors(const Contender& contender);

/// @throws std::invalid_argument if the scenario has rotors and the contender does not support them
void require_can_run(const Contender& contender, const Scenario& scenario);

struct ChosenContenders {
  std::vector<Contender> contenders;
  std::string note;  ///< names the contenders that were left out; one line, or empty
};

/// Keeps the contenders that can run the scenario.
ChosenContenders those_that_can_run(const std::vector<Contender>& contenders, const Scenario& scenario);

/// Returns the contenders with these names or, without names, the default ones that can run the scenario.
/// @throws std::invalid_argument as find_contenders and require_can_run
ChosenContenders chosen_contenders(const std::vector<std::string>& names, const Scenario& scenario);

}  // namespace polhode::demos
