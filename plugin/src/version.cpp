#include <polhode/version.h>

namespace polhode {

const char* version() noexcept {
  return POLHODE_VERSION_STRING;
}

}  // namespace polhode
