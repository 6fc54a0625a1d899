#pragma once

#include <functional>
#include <string>

namespace polhode::demos {

/// Runs a program's work and returns its exit code: 0, 2 for bad input, 128 + signal if interrupted. Prints
/// an exception as one line on stderr, unless `is_quiet` says that another process prints it.
int run_program(
    const std::string& program, const std::function<void()>& work,
    const std::function<bool()>& is_quiet = [] { return false; });

/// Prints lines to stdout and escapes characters that are not printable.
/// @throws std::runtime_error if stdout cannot be written
void print(const std::string& text);

}  // namespace polhode::demos
