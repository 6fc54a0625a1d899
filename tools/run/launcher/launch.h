#pragma once

#include <stdexcept>
#include <string>

#include "run/launcher/options.h"

namespace polhode::run {

/// A program that cannot be started, with the exit code that env uses for the reason.
class StartFailure : public std::runtime_error {
 public:
  StartFailure(int exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

/// Replaces this process by the program.
/// @throws StartFailure, or std::runtime_error for a program that cannot be rotated.
[[noreturn]] void launch(const Options& options);

}  // namespace polhode::run
