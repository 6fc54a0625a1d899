#include "run/interposer/report.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace polhode::run {

void replace_control_characters(char* text) {
  for (char* c = text; *c != '\0'; ++c) {
    if (static_cast<unsigned char>(*c) < ' ' || *c == '\177') *c = '?';
  }
}

void report(const char* line) {
  constexpr int kLongest = 2048;
  char text[kLongest];
  const int length = std::snprintf(text, kLongest - 1, "polhode-run: %s", line);
  if (length < 0) return;
  replace_control_characters(text);
  std::strcat(text, "\n");
  write_all(STDERR_FILENO, text);
}

bool write_all(int descriptor, const char* text) {
  const int errno_of_program = errno;
  std::size_t left = std::strlen(text);
  while (left > 0) {
    const ssize_t written = ::write(descriptor, text, left);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    text += written;
    left -= static_cast<std::size_t>(written);
  }
  if (left == 0) errno = errno_of_program;
  return left == 0;
}

}  // namespace polhode::run
