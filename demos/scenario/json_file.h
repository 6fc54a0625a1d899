#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Says what is wrong with a scenario, in one line that names the file, the key and what is valid.
class ScenarioError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Twice the depth of the deepest valid file. The JSON library copies and prints values recursively: a
/// million levels would overflow the stack.
inline constexpr int kDeepestJson = 16;

/// Parses `text`; `file_name` is for messages.
/// @throws ScenarioError on a syntax error, a number that overflows, a repeated key in an object, or lists
/// and objects nested deeper than kDeepestJson
nlohmann::json parse_json(const std::string& text, const std::string& file_name);

}  // namespace polhode::demos
