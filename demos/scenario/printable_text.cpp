#include "scenario/printable_text.h"

#include <boost/locale/utf.hpp>

namespace polhode::demos {

namespace {

using boost::locale::utf::code_point;

bool is_between(code_point first, code_point code, code_point last) {
  return first <= code && code <= last;
}

bool is_control(code_point code) {
  return code < 0x20 || is_between(0x7F, code, 0x9F) || is_between(0x2028, code, 0x2029);
}

// Unicode's property Bidi_Control.
bool is_directional_formatting(code_point code) {
  return code == 0x061C || is_between(0x200E, code, 0x200F) || is_between(0x202A, code, 0x202E) ||
         is_between(0x2066, code, 0x2069);
}

struct Character {
  std::string_view bytes;
  bool is_printable;
};

Character first_character(std::string_view text) {
  const char* next = text.data();
  const code_point code = boost::locale::utf::utf_traits<char>::decode(next, text.data() + text.size());
  if (!boost::locale::utf::is_valid_codepoint(code)) return {text.substr(0, 1), false};
  const auto size = static_cast<std::size_t>(next - text.data());
  return {text.substr(0, size), !is_control(code) && !is_directional_formatting(code)};
}

std::string escaped(std::string_view bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
  }
  return text;
}

}  // namespace

std::string_view first_unprintable(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!character.is_printable) return character.bytes;
    text.remove_prefix(character.bytes.size());
  }
  return {};
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    result += character.is_printable ? std::string(character.bytes) : escaped(character.bytes);
    text.remove_prefix(character.bytes.size());
  }
  return result;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    result += printable(text.substr(0, end)) + "\n";
    text.remove_prefix(end + 1);
  }
  return result + printable(text);
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  return text.substr(0, most / 2) + " ... " + text.substr(text.size() - most / 2);
}

}  // namespace polhode::demos
