#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text from outside (a file, its name, the command line), made safe to show. A terminal obeys control
/// characters, and directional formatting shows a text as another than it is.
namespace polhode::demos {

/// The first character that printable() escapes: a control character, a line or paragraph separator,
/// directional formatting, or a byte that is not UTF-8. Empty if there is none.
std::string_view first_unprintable(std::string_view text);

/// The text with each byte of such characters written as \xNN.
std::string printable(std::string_view text);

/// The same for each line of a text; newlines stay.
std::string printable_lines(std::string_view text);

/// The text, or its beginning and its end where it is longer than about `most` bytes.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace polhode::demos
