#include "command_line/interruption.h"

#include <csignal>

namespace polhode::demos {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_signal(int signal) {
  noted_signal = signal;
}

}  // namespace

void watch_for_interruption() {
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

int interrupting_signal() {
  return noted_signal;
}

void throw_if_interrupted() {
  if (noted_signal != 0) throw Interrupted(noted_signal);
}

}  // namespace polhode::demos
