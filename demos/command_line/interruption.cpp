#include "command_line/interruption.h"

#include <csignal>
#include <utility>

namespace polhode::demos {

namespace {

volatile std::sig_atomic_t noted_signal = 0;
thread_local const std::function<void()>* host_check = nullptr;

extern "C" void note_signal(int signal) {
  noted_signal = signal;
}

// A shell ignores signals for a background program, and nohup ignores the hangup; keep it that way.
void watch_for(int signal) {
  if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

void watch_for_interruption() {
  watch_for(SIGINT);
  watch_for(SIGTERM);
#ifdef SIGHUP
  watch_for(SIGHUP);
#endif
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the file size limit then fails with an error
#endif
}

int interrupting_signal() {
  return noted_signal;
}

InterruptionCheck::InterruptionCheck(std::function<void()> check) : check_(std::move(check)) {
  host_check = &check_;
}

InterruptionCheck::~InterruptionCheck() {
  host_check = nullptr;
}

void throw_if_interrupted() {
  if (host_check != nullptr) (*host_check)();
  if (noted_signal != 0) throw Interrupted(noted_signal);
}

}  // namespace polhode::demos
