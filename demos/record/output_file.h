#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace polhode::demos {

/// A file that appears completely or not at all: it is written under a temporary name in the same directory
/// and renamed by commit(). Without commit() nothing is left behind.
class OutputFile {
 public:
  /// @throws std::runtime_error if the file cannot be written
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws std::runtime_error, for example if the disk is full
  void write(std::string_view text);
  /// @throws std::runtime_error
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

/// Returns true if both paths lead to the same file, which may not exist yet.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace polhode::demos
