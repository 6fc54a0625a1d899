// Escapes untrusted text.
#include "scenario/printable_text.h"

#include <gtest/gtest.h>

namespace polhode::demos {
namespace {

struct Shown {
  std::string_view text;
  std::string printable;
};

std::ostream& operator<<(std::ostream& stream, const Shown& shown) {
  return stream << shown.printable;
}

class PrintableText : public testing::TestWithParam<Shown> {};

TEST_P(PrintableText, EscapesWhatATerminalObeysByteByByte) {
  EXPECT_EQ(printable(GetParam().text), GetParam().printable);
  EXPECT_EQ(printable(printable(GetParam().text)), GetParam().printable);
  EXPECT_EQ(first_unprintable(GetParam().text).empty(), GetParam().text == GetParam().printable);
}

using std::string_view_literals::operator""sv;

INSTANTIATE_TEST_SUITE_P(Plain, PrintableText,
                         testing::Values(Shown{"", ""}, Shown{"a b ~ \\x1b", "a b ~ \\x1b"},
                                         Shown{"Trägheit Å \u00a0 \u65e5\u672c \U0001F30D",
                                               "Trägheit Å \u00a0 \u65e5\u672c \U0001F30D"},
                                         Shown{"\u05e9\u05dc\u05d5\u05dd", "\u05e9\u05dc\u05d5\u05dd"}));

INSTANTIATE_TEST_SUITE_P(
    Controls, PrintableText,
    testing::Values(Shown{"a\0b"sv, "a\\x00b"}, Shown{"\t\n\r", "\\x09\\x0a\\x0d"},
                    Shown{"\x1b[2J", "\\x1b[2J"}, Shown{"\x1b]52;c;eA==\x07", "\\x1b]52;c;eA==\\x07"},
                    Shown{"\x1f\x20\x7e\x7f", "\\x1f ~\\x7f"},
                    Shown{"\u0080\u009b\u009f", "\\xc2\\x80\\xc2\\x9b\\xc2\\x9f"},
                    Shown{"\u2027\u2028\u2029", "\u2027\\xe2\\x80\\xa8\\xe2\\x80\\xa9"}));

INSTANTIATE_TEST_SUITE_P(
    DirectionalFormatting, PrintableText,
    testing::Values(Shown{"\u061c\u200e\u200f", "\\xd8\\x9c\\xe2\\x80\\x8e\\xe2\\x80\\x8f"},
                    Shown{"\u202a\u202e\u202f", "\\xe2\\x80\\xaa\\xe2\\x80\\xae\u202f"},
                    Shown{"\u2066\u2069\u206a", "\\xe2\\x81\\xa6\\xe2\\x81\\xa9\u206a"}));

INSTANTIATE_TEST_SUITE_P(NoUtf8, PrintableText,
                         testing::Values(Shown{"a\xff", "a\\xff"},
                                         Shown{"\x9b"
                                               "2J",
                                               "\\x9b2J"},
                                         Shown{"\xc3", "\\xc3"}, Shown{"\xc3(", "\\xc3("},
                                         Shown{"\xe2\x80", "\\xe2\\x80"},
                                         Shown{"\xc0\x9b", "\\xc0\\x9b"},                      // overlong
                                         Shown{"\xed\xa0\x80", "\\xed\\xa0\\x80"},             // surrogate
                                         Shown{"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"}));  // too large

TEST(PrintableText, KeepsTheNewlinesOfLines) {
  EXPECT_EQ(printable_lines("a\x1b\n\n\tb\n"), "a\\x1b\n\n\\x09b\n");
  EXPECT_EQ(printable_lines("a\r"), "a\\x0d");
}

TEST(PrintableText, OfALongTextHasItsBeginningAndItsEnd) {
  EXPECT_EQ(shortened("0123456789", 10), "0123456789");
  EXPECT_EQ(shortened("0123456789a", 4), "01 ... 9a");
}

}  // namespace
}  // namespace polhode::demos
