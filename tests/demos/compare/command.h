#pragma once

#include <string>
#include <vector>

#include "demos/support_files.h"

namespace polhode::demos {

struct CommandResult {
  int exit_code;  ///< -1 if a signal ended it
  std::string standard_output;
  std::string standard_error;
};

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
