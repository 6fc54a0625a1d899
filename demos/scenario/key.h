#pragma once

#include "scenario/range.h"

namespace polhode::demos {

/// `if_set`: optional, and written only if the value is not the default.
enum class Presence { optional, required, if_set };

/// A key of an object in a scenario file. The member that it is read into has the default.
struct Key {
  const char* name;
  Presence presence = Presence::optional;
  Range range = kAnySign;              ///< of each number
  const char* unit = "";               ///< and what else documentation says after the type
  const char* remark = "";             ///< in the documentation, after what is valid
  const char* default_text = nullptr;  ///< in the documentation, in place of the member's value
};

/// The alternatives of an object that a key of it chooses between, each named by its kKind.
template <class... Alternatives>
struct Kinds {};

}  // namespace polhode::demos
