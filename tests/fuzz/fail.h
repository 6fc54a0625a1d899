#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace polhode::fuzz {

/// Ends the fuzzer with a message.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "fuzzer: %s\n", what.c_str());
  std::abort();
}

}  // namespace polhode::fuzz
