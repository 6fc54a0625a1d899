#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Says what is wrong with a scenario: one line that names the file, the key and what is valid.
class ScenarioError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Twice as deep as any file goes. The JSON library copies and prints values recursively: a million levels would
/// overflow the stack.
inline constexpr int kDeepestJson = 16;

/// The JSON value in `text`; `file_name` is for messages.
/// @throws ScenarioError on a syntax error, a number that overflows, a key that an object has twice, or lists and
/// objects nested deeper than kDeepestJson.
nlohmann::json parse_json(const std::string& text, const std::string& file_name);

}  // namespace polhode::demos
