#include <stdexcept>

#include "command_line/interruption.h"
#include "workprecision/ranks.h"

namespace polhode::demos {

namespace {

// Describes as text how an action ended: empty for success, else the signal that interrupted it, or 0, and
// the message.
std::string outcome_of(const std::function<void()>& action) {
  try {
    action();
    return "";
  } catch (const Interrupted& interrupted) {
    return std::to_string(interrupted.signal()) + " " + interrupted.what();
  } catch (const std::exception& error) {
    return std::string("0 ") + error.what();
  }
}

[[noreturn]] void throw_outcome(const std::string& outcome) {
  const std::size_t space = outcome.find(' ');
  const int signal = std::stoi(outcome.substr(0, space));
  const std::string message = outcome.substr(space + 1);
  if (signal != 0) throw Interrupted(signal, message);
  throw std::runtime_error(message);
}

}  // namespace

void Ranks::together(const std::function<void()>& action) {
  std::string first_failure;
  for (const std::string& outcome : gather(outcome_of(action))) {
    if (first_failure.empty()) first_failure = outcome;
  }
  const std::string agreed = broadcast(first_failure);
  if (agreed.empty()) return;
  stopped_together_ = true;
  throw_outcome(agreed);
}

}  // namespace polhode::demos
