#include "scenario/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "scenario/range.h"

namespace polhode::demos {

namespace {

template <class... Arguments>
std::string to_text(Arguments... arguments) {
  std::array<char, 64> buffer;
  const std::to_chars_result result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), arguments...);
  return {buffer.data(), result.ptr};
}

}  // namespace

std::string number_text(double value) {
  return to_text(value);
}

std::string number_text(std::int64_t value) {
  return to_text(value);
}

std::string full_number_text(double value) {
  return short_number_text(value, 17);
}

std::string short_number_text(double value, int digits) {
  return to_text(value, std::chars_format::general, digits);
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string range_text(const Range& range) {
  return "a finite number between " + number_text(range.lowest) + " and " + number_text(range.highest);
}

}  // namespace polhode::demos
