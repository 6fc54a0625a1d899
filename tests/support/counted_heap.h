#pragma once

#include <cstddef>

/// The heap of an executable that counted_heap.cpp is compiled into: its operator new counts, and fails on
/// demand. Bullet's own memory comes from malloc and is neither counted nor refused.
namespace polhode::testing {

/// The number of allocations since the start.
std::size_t heap_allocations();
/// The number of allocations that are not freed.
std::size_t heap_blocks();

enum class MemoryReturns { at_once, when_told };

/// While this lives, the allocation after the next `granted` ones throws std::bad_alloc, and with
/// MemoryReturns::when_told all after it.
class MemoryShortage {
 public:
  MemoryShortage(std::size_t granted, MemoryReturns returns);
  ~MemoryShortage();
  MemoryShortage(const MemoryShortage&) = delete;
  MemoryShortage& operator=(const MemoryShortage&) = delete;

  /// Ends the shortage. Returns whether some allocation failed.
  bool end();
};

}  // namespace polhode::testing
