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

/// Returns the built-in scheme of that name.
/// @throws std::invalid_argument that lists the valid names.
SchemePointer find_scheme(std::string_view name);

/// Returns the scheme that a world's bodies get unless told otherwise.
SchemePointer default_scheme();

/// Returns the names of the built-in schemes, separated by ", ", for messages.
std::string scheme_names();

}  // namespace polhode
