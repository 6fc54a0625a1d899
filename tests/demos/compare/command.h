#pragma once

#include <string>
#include <vector>

#include "demos/support_files.h"

namespace polhode::demos {

struct CommandResult {
  int exit_code;  ///< -1 if a signal ended it
  std::string standard_output;
  std::string standard_error;
  double processor_seconds;
  double peak_megabytes;  ///< of resident memory, from the fork on: at least what the test itself has
};

/// AddressSanitizer keeps freed memory for a while, and some beside each allocation.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr double kMemoryFactor = 10.0;
#else
inline constexpr double kMemoryFactor = 1.0;
#endif

/// A program under way, its output caught.
class Command {
 public:
  Command(const std::string& program, const std::vector<std::string>& arguments,
          const std::vector<std::string>& environment = {});
  void send_signal(int signal) const;
  /// Waits for the end of the command. Call it once.
  CommandResult wait();

 private:
  TemporaryDirectory output_;
  int process_;
};

}  // namespace polhode::demos
