#include "command_line/program.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "command_line/interruption.h"
#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

constexpr int kBadInput = 2;
constexpr int kSignalBase = 128;  // as shells report it

void print_error(const std::string& program, const std::string& message) {
  constexpr std::size_t kLongest = 8192;  // fits a list of valid names and a file's whole path
  const std::string line = std::filesystem::path(program).filename().string() + ": " + message;
  // Written at once, since other processes may print to the same terminal.
  std::cerr << printable(shortened(line, kLongest)) + "\n" << std::flush;
}

}  // namespace

int run_program(const std::string& program, const std::function<void()>& work,
                const std::function<bool()>& is_quiet) {
  try {
    work();
    return 0;
  } catch (const Interrupted& interrupted) {
    if (!is_quiet()) print_error(program, interrupted.what());
    return kSignalBase + interrupted.signal();
  } catch (const std::exception& error) {
    if (!is_quiet()) print_error(program, error.what());
    // A signal may have ended the reading of a pipe.
    return interrupting_signal() != 0 ? kSignalBase + interrupting_signal() : kBadInput;
  }
}

void print(const std::string& text) {
  errno = 0;
  if (std::cout << printable_lines(text) << std::flush) return;
  throw std::runtime_error("standard output cannot be written" +
                           (errno == 0 ? std::string() : ": " + std::string(std::strerror(errno))));
}

}  // namespace polhode::demos
