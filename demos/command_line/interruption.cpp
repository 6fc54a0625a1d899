#include "command_line/interruption.h"

#include <csignal>

namespace polhode::demos {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_signal(int signal) {
  noted_signal = signal;
}

// A shell ignores signals for a program in the background, and nohup the hangup: that stays so.
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its writer
#endif
}

int interrupting_signal() {
  return noted_signal;
}

void throw_if_interrupted() {
  if (noted_signal != 0) throw Interrupted(noted_signal);
}

}  // namespace polhode::demos
