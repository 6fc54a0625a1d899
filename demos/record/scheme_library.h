#pragma once

#include <filesystem>

namespace polhode::demos {

/// Loads a library made with POLHODE_SCHEME_LIBRARY and registers its schemes. The library stays loaded until
/// the process ends.
/// @throws std::invalid_argument that names the file if it cannot be loaded, is not such a library, was
/// compiled with headers of another version, or has a scheme that cannot be registered
void load_scheme_library(const std::filesystem::path& file);

}  // namespace polhode::demos
