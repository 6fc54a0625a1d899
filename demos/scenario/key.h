#pragma once

#include "scenario/range.h"

namespace polhode::demos {

/// `if_set`: optional, and written only if the value is not the default.
enum class Presence { optional, required, if_set };

/// A key of an object in a scenario file. The default is the initial value of the member that the key is read
/// into.
struct Key {
  const char* name;
  Presence presence = Presence::optional;
  Range range = kAnySign;              ///< of each number
  const char* unit = "";               ///< and what else the documentation says after the type
  const char* remark = "";             ///< follows the valid range in the documentation
  const char* default_text = nullptr;  ///< replaces the member's value in the documentation
};

/// The alternatives that a key of an object chooses from, each named by its kKind.
template <class... Alternatives>
struct Kinds {};

}  // namespace polhode::demos
