#include "scenario/json_file.h"

#include <set>
#include <vector>

#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

constexpr std::size_t kLongestQuote = 100;  // bytes of a key, in a message

// Follows the parser through the keys: the last key read tells where a number overflowed.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& file_name) : file_name_(file_name) {}

  bool operator()(int levels_around, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (levels_around >= kDeepestJson && (event == Event::object_start || event == Event::array_start)) {
      throw ScenarioError(file_name_ + ": lists and objects are nested deeper than " +
                          std::to_string(kDeepestJson) + " levels; valid are at most " +
                          std::to_string(kDeepestJson));
    }
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key) note_key(parsed.get<std::string>());
    return true;
  }

  const std::string& last_key() const { return last_key_; }

 private:
  void note_key(const std::string& key) {
    last_key_ = key;
    if (!keys_.back().insert(key).second) {
      throw ScenarioError(file_name_ + ": \"" + shortened(key, kLongestQuote) +
                          "\": the key is given twice; valid is once");
    }
  }

  const std::string& file_name_;
  std::vector<std::set<std::string>> keys_;
  std::string last_key_;
};

// Removes the bracket of "[json.exception.parse_error.101] parse error at ..." and shortens a long token.
std::string reason(const nlohmann::json::exception& error) {
  const std::string message = error.what();
  const std::size_t end = message.find("] ");
  return shortened(end == std::string::npos ? message : message.substr(end + 2), 3 * kLongestQuote);
}

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& file_name) {
  // The library would take a zero byte for the end of the text and ignore the rest.
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    throw ScenarioError(file_name + ": byte " + std::to_string(zero + 1) +
                        " is a zero byte; valid is a JSON object");
  }
  KeyWatch watch(file_name);
  try {
    return nlohmann::json::parse(
        text, [&watch](int levels_around, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
          return watch(levels_around, event, parsed);
        });
  } catch (const nlohmann::json::out_of_range& error) {
    throw ScenarioError(file_name + ": \"" + shortened(watch.last_key(), kLongestQuote) +
                        "\": " + reason(error) + "; valid is a finite number");
  } catch (const nlohmann::json::exception& error) {
    throw ScenarioError(file_name + ": " + reason(error) + "; valid is a JSON object");
  }
}

}  // namespace polhode::demos
