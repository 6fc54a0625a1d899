// Run by CMake: returns exit code 0 if this machine has an OpenGL 3.3 context without a display.
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
