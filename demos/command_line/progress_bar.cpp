#include "command_line/progress_bar.h"

#include <unistd.h>

#include <iostream>

namespace polhode::demos {

namespace {

constexpr char kClearLine[] = "\r\033[K";

}  // namespace

ProgressBar::ProgressBar(std::int64_t total_steps)
    : total_steps_(total_steps), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (percent_shown_ >= 0) std::cerr << kClearLine << std::flush;
}

void ProgressBar::show(std::int64_t steps_done, const std::string& label) {
  if (!on_terminal_) return;
  const int percent = static_cast<int>(100 * steps_done / total_steps_);
  if (percent == percent_shown_) return;
  percent_shown_ = percent;
  const std::size_t filled = static_cast<std::size_t>(percent / 4);
  std::cerr << kClearLine << "[" << std::string(filled, '#') << std::string(25 - filled, ' ') << "] " << label
            << std::flush;
}

}  // namespace polhode::demos
