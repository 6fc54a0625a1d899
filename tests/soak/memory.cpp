#include "soak/memory.h"

#include <unistd.h>

#include <fstream>

#include "benchmark/heap_count.h"

namespace polhode::testing {

Memory memory_now() {
  std::int64_t all_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> all_pages >> resident_pages;
  return {benchmarks::heap_count().live_bytes, resident_pages * sysconf(_SC_PAGESIZE)};
}

}  // namespace polhode::testing
