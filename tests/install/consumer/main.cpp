#include <polhode/bullet/precision.h>
#include <polhode/version.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "consumer.h"

void require(bool condition, const char* text, const char* file, int line) {
  if (condition) return;
  std::fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, text);
  std::exit(1);
}

int main() {
  polhode::require_matching_bullet();
  // POLHODE_PACKAGE_VERSION is the version in CMake's or pkg-config's package file.
  REQUIRE(std::string(polhode::version()) == POLHODE_PACKAGE_VERSION);
  REQUIRE(std::string(POLHODE_VERSION_STRING) == POLHODE_PACKAGE_VERSION);
  rotates_a_world_whose_callbacks_and_user_pointer_are_taken();
  rotates_a_body_by_a_scheme_of_the_application();
  std::printf("the consumer ran in %d bits\n", static_cast<int>(8 * sizeof(btScalar)));
}
