#pragma once

#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Reports Ctrl-C, a termination request or the terminal's end as an exception, so that destructors remove
/// half-written files.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal, const std::string& message = "interrupted; no file was written")
      : std::runtime_error(message), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

/// Starts noting these signals. Also makes writing beyond the file size limit fail instead of ending the
/// program.
void watch_for_interruption();

/// Returns the signal noted, 0 if there is none.
int interrupting_signal();

/// @throws Interrupted if one was noted.
void throw_if_interrupted();

}  // namespace polhode::demos
