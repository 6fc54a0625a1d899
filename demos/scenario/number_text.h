#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Converts numbers to text and back, with a '.' and no grouping in any locale.
namespace polhode::demos {

/// Returns the shortest text that reads back as the same number.
std::string number_text(double value);
std::string number_text(std::int64_t value);

/// Returns 17 significant digits.
std::string full_number_text(double value);

/// Returns `digits` significant digits, as printf's %g.
std::string short_number_text(double value, int digits);

/// Returns the number if it is finite and all of `text`, else nothing.
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode::demos
