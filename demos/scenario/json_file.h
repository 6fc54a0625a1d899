#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Says what is wrong with a scenario: one line that names the file, the key and what is valid.
class ScenarioError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The content of a regular file.
/// @throws ScenarioError if it cannot be read.
std::string read_text_file(const std::filesystem::path& file);

/// The JSON value in `text`; `file_name` is for messages.
/// @throws ScenarioError on a syntax error, a number that overflows, or a key that an object has twice.
nlohmann::json parse_json(const std::string& text, const std::string& file_name);

}  // namespace polhode::demos
