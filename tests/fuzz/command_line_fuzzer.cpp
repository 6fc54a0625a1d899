// Parses command lines of the demos, one argument per line. Rejected command lines must throw
// std::invalid_argument.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "compare/options.h"
#include "viewer/model/options.h"
#include "workprecision/options.h"

namespace polhode::demos {
namespace {

template <class Parser>
void parse(std::string text, const Parser& parser) {
  std::vector<std::string> arguments = {"program"};
  std::istringstream lines(text);
  // up to the first NUL
  for (std::string line; std::getline(lines, line);) arguments.push_back(line.c_str());
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  try {
    parser(static_cast<int>(arguments.size()), pointers.data());
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace
}  // namespace polhode::demos

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode::demos;
  const std::string text(reinterpret_cast<const char*>(data), size);
  parse(text, parse_options);
  parse(text, parse_viewer_options);
  parse(text, parse_work_precision_options);
  return 0;
}
