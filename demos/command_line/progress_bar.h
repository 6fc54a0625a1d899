#pragma once

#include <cstdint>
#include <string>

namespace polhode::demos {

/// Shows a bar on stderr during its lifetime, if stderr is a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::int64_t total_steps);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::int64_t steps_done, const std::string& label);

 private:
  std::int64_t total_steps_;
  int percent_shown_ = -1;
  bool on_terminal_;
};

}  // namespace polhode::demos
