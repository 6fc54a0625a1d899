// Rotates one scenario by several contenders and prints how well each kept energy, momentum and shape. Built
// once for each of Bullet's precisions.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "compare/comparison.h"
#include "compare/interruption.h"
#include "record/table.h"

namespace {

constexpr int kBadInput = 2;
constexpr int kSignalBase = 128;  // as shells report it

void print_error(const char* program, std::string message) {
  // One line, whatever characters the command line or a file brought in.
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' '; }, ' ');
  std::cerr << std::filesystem::path(program).filename().string() << ": " << message << "\n";
}

void print(const std::string& text) {
  if (!(std::cout << text << std::flush)) throw std::runtime_error("standard output cannot be written");
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace polhode::demos;
  const char* program = argument_count > 0 ? arguments[0] : "polhode_compare";
  try {
    const std::optional<Options> options = parse_options(argument_count, arguments);
    if (!options) return 0;
    watch_for_interruption();
    print(options->list ? list_text() : comparison_table(compare(*options)));
    return 0;
  } catch (const Interrupted& interrupted) {
    print_error(program, interrupted.what());
    return kSignalBase + interrupted.signal();
  } catch (const std::exception& error) {
    print_error(program, error.what());
    return kBadInput;
  }
}
