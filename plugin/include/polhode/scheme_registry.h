#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/rotation_scheme.h"

namespace polhode {

/// Shared, because a scheme must outlive every body that it rotates.
using SchemePointer = std::shared_ptr<const RotationScheme>;

/// Returns every built-in scheme, in the order of the list plugin/src/schemes/schemes.list.
const std::vector<SchemePointer>& built_in_schemes();

/// Makes a scheme of the application known under the name in its description, to find_scheme and so to every function
/// that takes a name. A scheme that was registered under the same name before is replaced; bodies that have it keep it.
/// May be called from any thread. A registered scheme lives until the process ends.
/// @throws std::invalid_argument for a null pointer, a name that is not of the form [a-z][a-z0-9_]*, or one of a built-in
/// scheme.
void register_scheme(SchemePointer scheme);

/// Returns the built-in schemes and then the registered ones, in the order in which their names were first registered.
std::vector<SchemePointer> all_schemes();

/// Returns the built-in or registered scheme of that name.
/// @throws std::invalid_argument that lists the valid names.
SchemePointer find_scheme(std::string_view name);

/// Returns the scheme that a world's bodies get unless told otherwise.
SchemePointer default_scheme();

/// Returns the names of all_schemes(), separated by ", ", for messages.
std::string scheme_names();

}  // namespace polhode
