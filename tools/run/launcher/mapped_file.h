#pragma once

#include <filesystem>
#include <string_view>

namespace polhode::run {

/// Maps a regular file into memory for the lifetime of this object. Empty if the file cannot be read.
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
