#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

/// Reads files in bounded memory and time, whatever they contain.
namespace polhode::demos {

/// Says why a file cannot be read, without the file's name.
class InputFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the content of a regular file, or of a pipe such as a shell makes for <(...). The other end of a
/// pipe must be closed within `patience`.
/// @throws InputFileError, also if there are more than `most` bytes
std::string read_text_file(const std::filesystem::path& file, std::size_t most,
                           std::chrono::milliseconds patience = std::chrono::seconds(30));

/// Opens a regular file for reading line by line.
/// @throws InputFileError
std::ifstream open_regular_file(const std::filesystem::path& file);

/// Reads the next line, without its newline. Returns false at the end of the file, and for a line of more
/// than `longest` bytes, whose beginning is then in `line`.
bool read_line(std::istream& stream, std::size_t longest, std::string& line);

}  // namespace polhode::demos
