#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/rotation_scheme.h"

namespace polhode {

/// Shared, because a scheme must outlive all bodies that it rotates.
using SchemePointer = std::shared_ptr<const RotationScheme>;

/// Returns the built-in schemes, in the order of plugin/src/schemes/schemes.list.
const std::vector<SchemePointer>& built_in_schemes();

/// Registers a scheme under the name in its description, for find_scheme and all functions that take a name.
/// Replaces a scheme registered under the same name before; bodies that use the replaced scheme keep it.
/// Thread-safe. A registered scheme lives until the process ends.
/// @throws std::invalid_argument for a null pointer, a name that is not of the form [a-z][a-z0-9_]*, or the
/// name of a built-in scheme.
void register_scheme(SchemePointer scheme);

/// Returns the built-in schemes, then the registered ones in the order in which their names were first
/// registered.
std::vector<SchemePointer> all_schemes();

/// Returns the built-in or registered scheme of this name.
/// @throws std::invalid_argument for an unknown name; the message lists the valid ones.
SchemePointer find_scheme(std::string_view name);

/// Returns the scheme that the bodies of a new world use: `exact`.
SchemePointer default_scheme();

/// Returns the names of all_schemes(), separated by ", ".
std::string scheme_names();

}  // namespace polhode
