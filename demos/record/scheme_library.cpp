#include "record/scheme_library.h"

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "polhode/scheme_library.h"

namespace polhode::demos {

namespace {

constexpr int kPatches = 100;  // POLHODE_VERSION / kPatches are major and minor version

std::string version_text(int version) {
  return std::to_string(version / (kPatches * kPatches)) + "." +
         std::to_string(version / kPatches % kPatches);
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw std::invalid_argument("scheme library " + file.string() + ": " + reason);
}

boost::dll::shared_library load(const std::filesystem::path& file) {
  try {
    return boost::dll::shared_library(std::filesystem::absolute(file));
  } catch (const std::system_error& error) {
    refuse(file, std::string("cannot be loaded: ") + error.what());
  }
}

void require_this_version(const boost::dll::shared_library& library, const std::filesystem::path& file) {
  if (!library.has("polhode_scheme_library") || !library.has("polhode_scheme_library_version"))
    refuse(file, "is not a library of rotation schemes; valid is one made with POLHODE_SCHEME_LIBRARY");
  const int version = library.get<int()>("polhode_scheme_library_version")();
  if (version / kPatches != POLHODE_VERSION / kPatches) {
    refuse(file, "was compiled for polhode " + version_text(version) + "; valid is " +
                     version_text(POLHODE_VERSION));
  }
}

}  // namespace

void load_scheme_library(const std::filesystem::path& file) {
  // Never unloaded, since it holds the schemes' code.
  const auto& library = *new boost::dll::shared_library(load(file));
  require_this_version(library, file);
  std::vector<SchemePointer> schemes;
  library.get<void(std::vector<SchemePointer>&)>("polhode_scheme_library")(schemes);
  try {
    for (const SchemePointer& scheme : schemes) register_scheme(scheme);
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what());
  }
}

}  // namespace polhode::demos
