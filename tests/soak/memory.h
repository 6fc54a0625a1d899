#pragma once

#include <cstdint>

namespace polhode::testing {

struct Memory {
  std::int64_t heap_bytes;      ///< live bytes from operator new and Bullet, as requested
  std::int64_t resident_bytes;  ///< resident memory of the process; 0 if /proc is not available
};

Memory memory_now();

}  // namespace polhode::testing
