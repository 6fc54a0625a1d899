#include "scenario/json_file.h"

#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <vector>

#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

// A scenario has some dozen lines; this is for a file given by mistake.
constexpr std::uintmax_t kLargestFile = 1 << 20;

constexpr std::size_t kLongestQuote = 100;  // bytes of a key, in a message

// Follows the parser through the keys: the last one read says where a number overflowed.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& file_name) : file_name_(file_name) {}

  bool operator()(nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
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
                          "\": the key is there twice, it may be given once");
    }
  }

  const std::string& file_name_;
  std::vector<std::set<std::string>> keys_;
  std::string last_key_;
};

// "[json.exception.parse_error.101] parse error at ..." without the bracket, and with little of a long token.
std::string reason(const nlohmann::json::exception& error) {
  const std::string message = error.what();
  const std::size_t end = message.find("] ");
  return shortened(end == std::string::npos ? message : message.substr(end + 2), 3 * kLongestQuote);
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw ScenarioError(file.string() +
                        ": no such file; a scenario is a JSON file, see --list for those at hand");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw ScenarioError(file.string() + ": not a regular file; a scenario is a JSON file");
  }
  if (std::filesystem::file_size(file, error) > kLargestFile) {
    throw ScenarioError(file.string() + ": a scenario has at most " + std::to_string(kLargestFile) +
                        " bytes");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw ScenarioError(file.string() + ": cannot be read; a scenario is a readable JSON file");
  return text;
}

nlohmann::json parse_json(const std::string& text, const std::string& file_name) {
  KeyWatch watch(file_name);
  try {
    return nlohmann::json::parse(text, [&watch](int /*depth*/, nlohmann::json::parse_event_t event,
                                                nlohmann::json& parsed) { return watch(event, parsed); });
  } catch (const nlohmann::json::out_of_range& error) {
    throw ScenarioError(file_name + ": \"" + shortened(watch.last_key(), kLongestQuote) +
                        "\": " + reason(error) + "; valid is a finite number");
  } catch (const nlohmann::json::exception& error) {
    throw ScenarioError(file_name + ": " + reason(error) + "; valid is a JSON object");
  }
}

}  // namespace polhode::demos
