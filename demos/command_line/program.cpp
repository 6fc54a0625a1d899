#include "command_line/program.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "command_line/interruption.h"

namespace polhode::demos {

namespace {

constexpr int kBadInput = 2;
constexpr int kSignalBase = 128;  // as shells report it

void print_error(const std::string& program, std::string message) {
  // One line, whatever characters the command line or a file brought in.
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' '; }, ' ');
  // In one piece, since other processes may print to the same place.
  std::cerr << std::filesystem::path(program).filename().string() + ": " + message + "\n" << std::flush;
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
    return kBadInput;
  }
}

void print(const std::string& text) {
  errno = 0;
  if (std::cout << text << std::flush) return;
  throw std::runtime_error("standard output cannot be written" +
                           (errno == 0 ? std::string() : ": " + std::string(std::strerror(errno))));
}

}  // namespace polhode::demos
