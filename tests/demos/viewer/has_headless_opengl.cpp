// Run by CMake: exit code 0 if this machine gives an OpenGL 3.3 context without a display.
#include <exception>

#include "viewer/graphics/headless_context.h"

int main() {
  try {
    const polhode::demos::HeadlessContext context;
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}
