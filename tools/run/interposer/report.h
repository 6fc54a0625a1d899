#pragma once

namespace polhode::run {

/// Prints "polhode-run: " and the line on standard error, in one piece and control characters replaced.
/// Uses no more than the C library: every program that the program starts loads the interposer too.
void report(const char* line);

/// Replaces what a terminal would not print as it stands by question marks.
void replace_control_characters(char* text);

/// Writes a text to a descriptor; returns false if that fails.
bool write_all(int descriptor, const char* text);

}  // namespace polhode::run
