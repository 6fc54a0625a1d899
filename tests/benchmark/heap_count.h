#pragma once

#include <cstdint>

namespace polhode::benchmarks {

/// Counts the heap use of this process through operator new, and Bullet's memory once count_heap_of_bullet
/// was called. Direct calls of malloc are not counted.
struct HeapCount {
  std::int64_t live_bytes = 0;   ///< as they were asked for
  std::int64_t allocations = 0;  ///< since the start
};

HeapCount heap_count();

/// Counts Bullet's memory too from now on. Call it before Bullet allocates.
void count_heap_of_bullet();

}  // namespace polhode::benchmarks
