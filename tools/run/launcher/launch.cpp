#include "run/launcher/launch.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "run/install_paths.h"
#include "run/launcher/program_file.h"
#include "run/settings.h"

namespace polhode::run {

namespace {

namespace fs = std::filesystem;

constexpr int kCannotBeExecuted = 126;
constexpr int kNotFound = 127;

// Relative to this executable, so that the tree can be moved.
std::string interposer() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path() / kLibrariesFromExecutable;
  const std::string file = (folder / "libpolhode_run.so").lexically_normal().string();
  if (::access(file.c_str(), R_OK) != 0)
    throw std::runtime_error(file + ": cannot be read: " + std::strerror(errno));
  // LD_PRELOAD is split at spaces and colons and has no quoting.
  if (file.find_first_of(" :") != std::string::npos)
    throw std::runtime_error(
        file +
        ": LD_PRELOAD does not allow spaces or colons in this path: move polhode-run to another folder");
  return file;
}

void set(const char* variable, const std::string& value) {
  if (::setenv(variable, value.c_str(), 1) != 0)
    throw std::runtime_error(std::string(variable) + ": cannot be set: " + std::strerror(errno));
}

void set_environment(const Options& options) {
  const char* const others = std::getenv("LD_PRELOAD");
  const bool has_others = others != nullptr && *others != '\0';
  set("LD_PRELOAD", interposer() + (has_others ? std::string(":") + others : ""));
  set(kSchemeVariable, options.scheme);
  set(kSummaryVariable, options.summary);
  set(kProcessVariable, std::to_string(::getpid()));
}

// Also detects now that the file cannot be written. Each process appends to the file.
void clear_summary_file(const std::string& summary) {
  if (summary.empty() || summary == kToStandardError) return;
  const int file = ::open(summary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
    throw std::runtime_error("--summary: \"" + summary + "\": cannot be written: " + std::strerror(errno));
  ::close(file);
}

void check_program(const std::string& name) {
  const std::optional<fs::path> file = find_program(name);
  if (!file) throw StartFailure(kNotFound, name + ": no such program");
  const std::string reason = reason_against(*file);
  if (!reason.empty()) throw std::runtime_error(file->string() + ": " + reason);
}

[[noreturn]] void execute(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(pointers[0], pointers.data());
  throw StartFailure(errno == ENOENT ? kNotFound : kCannotBeExecuted,
                     words.front() + ": cannot be executed: " + std::strerror(errno));
}

}  // namespace

void launch(const Options& options) {
  check_program(options.program.front());
  clear_summary_file(options.summary);
  set_environment(options);
  execute(options.program);
}

}  // namespace polhode::run
