#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Makes text from outside (a file, its name, the command line) safe to show. A terminal obeys control
/// characters, and directional formatting can disguise a text.
namespace polhode::demos {

/// Returns the first character that printable() escapes: a control character, a line or paragraph separator,
/// directional formatting, or a byte that is not UTF-8. Empty if there is none.
std::string_view first_unprintable(std::string_view text);

/// Returns the text with each byte of such characters written as \xNN.
std::string printable(std::string_view text);

/// Does the same for each line of a text and keeps newlines.
std::string printable_lines(std::string_view text);

/// Returns the text, or its beginning and end if it is longer than about `most` bytes.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace polhode::demos
