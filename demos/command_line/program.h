#pragma once

#include <functional>
#include <string>

namespace polhode::demos {

/// Does the work of a program and returns its exit code: 0, 2 for bad input, 128 + signal when interrupted.
/// Prints an exception as one line on stderr, unless `is_quiet` then says that another process prints it.
int run_program(
    const std::string& program, const std::function<void()>& work,
    const std::function<bool()>& is_quiet = [] { return false; });

/// Prints lines to stdout, what is not printable in them escaped.
/// @throws std::runtime_error if that cannot be written.
void print(const std::string& text);

}  // namespace polhode::demos
