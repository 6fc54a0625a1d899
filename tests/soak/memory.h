#pragma once

#include <cstdint>

namespace polhode::testing {

struct Memory {
  std::int64_t heap_bytes;      ///< live, of operator new and of Bullet, as they were asked for
  std::int64_t resident_bytes;  ///< of the process; 0 where /proc does not tell
};

Memory memory_now();

}  // namespace polhode::testing
