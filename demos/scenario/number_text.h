#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers as text and back, with a '.' and no grouping whatever the locale.
namespace polhode::demos {

/// The shortest text that reads back as the same number.
std::string number_text(double value);
std::string number_text(std::int64_t value);

/// 17 significant digits.
std::string full_number_text(double value);

/// `digits` significant digits, as printf's %g.
std::string short_number_text(double value, int digits);

/// The number that is all of `text`; nothing if there is something else in it, or it is not finite.
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode::demos
