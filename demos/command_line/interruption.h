#pragma once

#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Ctrl-C, a termination request or the terminal's end, as an exception, so that destructors remove
/// half-written files.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal, const std::string& message = "interrupted; no file was written")
      : std::runtime_error(message), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

/// Notes such a signal from now on. A limit on the size of files no longer ends the program either: writing
/// fails.
void watch_for_interruption();

/// Returns that signal, 0 if there was none.
int interrupting_signal();

/// @throws Interrupted if one was noted.
void throw_if_interrupted();

}  // namespace polhode::demos
