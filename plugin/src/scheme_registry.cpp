#include "polhode/scheme_registry.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "scheme_base/scheme_definition.h"

namespace polhode {

namespace {

// The built-in schemes live as long as the process, so the pointer does not own them.
SchemePointer unowned(const RotationScheme& scheme) {
  return {SchemePointer(), &scheme};
}

// Stores the name, so that no code of the application runs while the mutex is held.
struct RegisteredScheme {
  std::string name;
  SchemePointer scheme;
};

struct RegisteredSchemes {
  std::mutex mutex;
  std::vector<RegisteredScheme> list;
};

// Never destroyed: a scheme may be written in a language whose runtime ends before the process does.
RegisteredSchemes& registered() {
  static auto& schemes = *new RegisteredSchemes;
  return schemes;
}

auto find_in(const std::vector<SchemePointer>& list, std::string_view name) {
  return std::find_if(list.begin(), list.end(),
                      [name](const SchemePointer& scheme) { return scheme->description().name == name; });
}

void require_valid_name(std::string_view name) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
  constexpr std::string_view kOthers = "0123456789_";
  const auto is_valid = [&](char c) {
    return kLetters.find(c) != std::string_view::npos || kOthers.find(c) != std::string_view::npos;
  };
  if (!name.empty() && kLetters.find(name.front()) != std::string_view::npos &&
      std::all_of(name.begin(), name.end(), is_valid))
    return;
  throw std::invalid_argument(
      "a rotation scheme cannot be registered under the name \"" + std::string(name) +
      "\": valid are lower-case letters, digits and underscores, starting with a letter");
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

void register_scheme(SchemePointer scheme) {
  if (scheme == nullptr) throw std::invalid_argument("the scheme to register is a null pointer");
  const std::string name(scheme->description().name);
  require_valid_name(name);
  if (find_in(built_in_schemes(), name) != built_in_schemes().end()) {
    throw std::invalid_argument("the rotation scheme \"" + name + "\" is built in: choose another name");
  }
  RegisteredSchemes& schemes = registered();
  SchemePointer replaced;  // destroyed after the lock, since its destructor is the application's code
  const std::lock_guard<std::mutex> lock(schemes.mutex);
  const auto known = std::find_if(schemes.list.begin(), schemes.list.end(),
                                  [&](const RegisteredScheme& other) { return other.name == name; });
  if (known == schemes.list.end()) {
    schemes.list.push_back({name, std::move(scheme)});
  } else {
    replaced = std::exchange(known->scheme, std::move(scheme));
  }
}

std::vector<SchemePointer> all_schemes() {
  std::vector<SchemePointer> all = built_in_schemes();
  RegisteredSchemes& schemes = registered();
  const std::lock_guard<std::mutex> lock(schemes.mutex);
  for (const RegisteredScheme& registered_scheme : schemes.list) all.push_back(registered_scheme.scheme);
  return all;
}

SchemePointer find_scheme(std::string_view name) {
  const std::vector<SchemePointer> all = all_schemes();
  const auto found = find_in(all, name);
  if (found != all.end()) return *found;
  throw std::invalid_argument("unknown rotation scheme \"" + std::string(name) + "\": valid are " +
                              scheme_names());
}

SchemePointer default_scheme() {
  return unowned(schemes::exact());
}

std::string scheme_names() {
  std::string names;
  for (const SchemePointer& scheme : all_schemes()) {
    if (!names.empty()) names += ", ";
    names += scheme->description().name;
  }
  return names;
}

}  // namespace polhode
