#pragma once

namespace polhode::run {

/// Prints "polhode-run: " and the line to standard error in one piece, with control characters replaced.
/// Uses only the C library, since every process that the program starts loads the interposer.
void report(const char* line);

/// Replaces control characters by question marks.
void replace_control_characters(char* text);

/// Writes a text to a file descriptor. Returns false on failure.
bool write_all(int descriptor, const char* text);

}  // namespace polhode::run
