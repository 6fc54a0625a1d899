#pragma once

#include <functional>
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

/// Makes throw_if_interrupted call `check` too, in this thread and during the object's lifetime, for a host
/// that handles signals itself, such as Python. `check` may throw anything.
class InterruptionCheck {
 public:
  explicit InterruptionCheck(std::function<void()> check);
  ~InterruptionCheck();
  InterruptionCheck(const InterruptionCheck&) = delete;
  InterruptionCheck& operator=(const InterruptionCheck&) = delete;

 private:
  std::function<void()> check_;
};

/// @throws Interrupted if a signal was noted, and what a check throws.
void throw_if_interrupted();

}  // namespace polhode::demos
