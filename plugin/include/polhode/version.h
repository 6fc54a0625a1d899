#pragma once

/// Version of these headers. CMakeLists.txt reads the three numbers from here.
#define POLHODE_VERSION_MAJOR 0
#define POLHODE_VERSION_MINOR 2
#define POLHODE_VERSION_PATCH 0

/// Version as one number, 10000 major + 100 minor + patch: `#if POLHODE_VERSION >= 200` tests for 0.2.0 or
/// later.
#define POLHODE_VERSION (10000 * POLHODE_VERSION_MAJOR + 100 * POLHODE_VERSION_MINOR + POLHODE_VERSION_PATCH)

/// "major.minor.patch"
#define POLHODE_VERSION_STRING         \
  POLHODE_QUOTE(POLHODE_VERSION_MAJOR) \
  "." POLHODE_QUOTE(POLHODE_VERSION_MINOR) "." POLHODE_QUOTE(POLHODE_VERSION_PATCH)
#define POLHODE_QUOTE(number) POLHODE_QUOTE_EXPANDED(number)
#define POLHODE_QUOTE_EXPANDED(text) #text

namespace polhode {

/// Returns the version of the linked library, "major.minor.patch". A shared library may be newer than
/// POLHODE_VERSION_STRING, the version of the headers that the caller was compiled with.
const char* version() noexcept;

}  // namespace polhode
