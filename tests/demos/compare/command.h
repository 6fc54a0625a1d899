#pragma once

#include <functional>
#include <string>
#include <vector>

#include "demos/support_files.h"

namespace polhode::demos {

struct CommandResult {
  int exit_code;  ///< minus the signal's number if a signal ended it
  std::string standard_output;
  std::string standard_error;
  double processor_seconds;
  double peak_megabytes;  ///< of resident memory since the fork, at least that of the test itself
};

/// Expects exit code 2 and one line on stderr.
void expect_refused_in_one_line(const CommandResult& result);

/// AddressSanitizer keeps freed memory for a while and adds some to each allocation; the total is several
/// times as large.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr double kMemoryFactor = 10.0;
inline constexpr double kTimeFactor = 10.0;
#else
inline constexpr double kMemoryFactor = 1.0;
inline constexpr double kTimeFactor = 1.0;
#endif

/// A running program whose output is captured.
class Command {
 public:
  /// `environment` has NAME=VALUE, or NAME to unset it. Calls prepare() in the new process.
  Command(
      const std::string& program, const std::vector<std::string>& arguments,
      const std::vector<std::string>& environment = {}, const std::function<void()>& prepare = [] {});
  void send_signal(int signal) const;
  int process() const { return process_; }
  /// Waits for the end of the program. Call it once.
  CommandResult wait();

 private:
  TemporaryDirectory output_;
  int process_;
};

}  // namespace polhode::demos
