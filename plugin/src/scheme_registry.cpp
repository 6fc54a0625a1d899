#include "polhode/scheme_registry.h"

#include <stdexcept>

#include "scheme_base/scheme_definition.h"

namespace polhode {

namespace {

// The definitions live as long as the process: the pointer shares without owning.
SchemePointer unowned(const RotationScheme& scheme) {
  return {SchemePointer(), &scheme};
}

}  // namespace

const std::vector<SchemePointer>& built_in_schemes() {
  static const std::vector<SchemePointer> list = {
#define POLHODE_SCHEME(name) unowned(schemes::name()),
#include "schemes/schemes.list"
#undef POLHODE_SCHEME
  };
  return list;
}

SchemePointer find_scheme(std::string_view name) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (scheme->description().name == name) return scheme;
  }
  throw std::invalid_argument("unknown rotation scheme \"" + std::string(name) + "\": valid are " +
                              scheme_names());
}

SchemePointer default_scheme() {
  return unowned(schemes::exact());
}

std::string scheme_names() {
  std::string names;
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (!names.empty()) names += ", ";
    names += scheme->description().name;
  }
  return names;
}

}  // namespace polhode
