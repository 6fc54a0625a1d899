#include "run/launcher/program_file.h"

#include <elf.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string_view>

#include "run/launcher/mapped_file.h"

namespace polhode::run {

namespace {

namespace fs = std::filesystem;

bool is_executable_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

// For such a program the loader ignores LD_PRELOAD.
bool gets_other_rights(const fs::path& program) {
  struct stat status {};
  if (::stat(program.c_str(), &status) != 0) return false;
  const bool is_other_user = (status.st_mode & S_ISUID) != 0 && status.st_uid != ::geteuid();
  const bool is_other_group = (status.st_mode & S_ISGID) != 0 && status.st_gid != ::getegid();
  const bool has_capabilities =
      ::geteuid() != 0 && ::getxattr(program.c_str(), "security.capability", nullptr, 0) > 0;
  return is_other_user || is_other_group || has_capabilities;
}

// Searches for the class name in the type information of the file. A match inside a longer symbol does not
// count.
bool defines_world_class(std::string_view bytes) {
  constexpr std::string_view kTypeName("23btDiscreteDynamicsWorld\0", 26);
  for (std::size_t at = bytes.find(kTypeName); at != std::string_view::npos;
       at = bytes.find(kTypeName, at + 1)) {
    const auto before = static_cast<unsigned char>(at == 0 ? '\0' : bytes[at - 1]);
    if (std::isalnum(before) == 0 && before != '_') return true;
  }
  return false;
}

bool has_interpreter(std::string_view bytes, const Elf64_Ehdr& header) {
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr part;
    const std::size_t at = header.e_phoff + i * sizeof part;
    if (at > bytes.size() || bytes.size() - at < sizeof part) return false;
    std::memcpy(&part, bytes.data() + at, sizeof part);
    if (part.p_type == PT_INTERP) return true;
  }
  return false;
}

// Returns the ELF header of this program.
Elf64_Ehdr own_header() {
  Elf64_Ehdr header{};
  const MappedFile self("/proc/self/exe");
  if (self.bytes().size() >= sizeof header) std::memcpy(&header, self.bytes().data(), sizeof header);
  return header;
}

std::string reason_against_elf(std::string_view bytes) {
  Elf64_Ehdr header;
  if (bytes.size() < sizeof header) return "is not a whole ELF file";
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_machine != own_header().e_machine)
    return "is for another kind of machine than polhode-run";
  if (!has_interpreter(bytes, header)) return "is linked statically, so nothing can be loaded into it";
  if (defines_world_class(bytes) && bytes.find("libBulletDynamics") == std::string_view::npos) {
    return "has Bullet linked into it statically, so its steps cannot be intercepted: link it to Bullet's "
           "shared libraries, or to polhode itself";
  }
  return "";
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    std::error_code error;
    return fs::exists(name, error) ? std::optional<fs::path>(name) : std::nullopt;
  }
  const char* const folders = std::getenv("PATH");
  std::istringstream list(folders == nullptr ? "/bin:/usr/bin" : folders);
  for (std::string folder; std::getline(list, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
    if (is_executable_file(file)) return file;
  }
  return std::nullopt;
}

std::string reason_against(const fs::path& program) {
  if (gets_other_rights(program))
    return "runs with another user's or group's rights, so nothing can be loaded into it";
  const MappedFile file(program);
  const bool is_elf = file.bytes().substr(0, SELFMAG) == std::string_view(ELFMAG, SELFMAG);
  return is_elf ? reason_against_elf(file.bytes()) : "";
}

}  // namespace polhode::run
