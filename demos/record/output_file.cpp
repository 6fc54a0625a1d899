#include "record/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace polhode::demos {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& target, const std::string& reason) {
  throw std::runtime_error("\"" + target.string() + "\": cannot be written: " + reason +
                           "; valid is a file in an existing, writable directory");
}

std::string last_error() {
  return std::strerror(errno);
}

// Follows links: renaming onto a link would replace the link instead of its target.
fs::path without_links(const fs::path& target) {
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(target, error);
  return error ? target : resolved;
}

}  // namespace

OutputFile::OutputFile(const fs::path& target) : target_(without_links(target)) {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  // Renaming onto a device such as /dev/null would replace the device.
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(target, "not a regular file");
  if (fs::exists(status) && ::access(target_.c_str(), W_OK) != 0) fail(target, last_error());
  if (!target_.has_filename()) fail(target, "no file name");
  temporary_ = target_;
  temporary_ += ".partial-" + std::to_string(::getpid());
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail(target, last_error());
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view text) {
  if (!stream_.write(text.data(), static_cast<std::streamsize>(text.size()))) fail(target_, last_error());
}

void OutputFile::commit() {
  stream_.close();
  if (!stream_) fail(target_, last_error());
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(target_, error.message());
  temporary_.clear();
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return without_links(fs::absolute(a)) == without_links(fs::absolute(b)) || fs::equivalent(a, b, error);
}

}  // namespace polhode::demos
