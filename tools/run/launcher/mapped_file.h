#pragma once

#include <filesystem>
#include <string_view>

namespace polhode::run {

/// The bytes of a regular file, mapped while this lives; none if it cannot be read.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
};

}  // namespace polhode::run
