#pragma once

#include <cstdint>

namespace polhode::benchmarks {

/// Counts the heap use of this process through operator new and, after count_heap_of_bullet, Bullet's memory.
/// Does not count direct calls of malloc.
struct HeapCount {
  std::int64_t live_bytes = 0;   ///< as requested
  std::int64_t allocations = 0;  ///< since the start
};

HeapCount heap_count();

/// Also counts Bullet's memory from now on. Call before Bullet allocates.
void count_heap_of_bullet();

}  // namespace polhode::benchmarks
