#pragma once

#include <cstddef>

/// Heap of an executable that contains counted_heap.cpp: operator new counts allocations, and fails on
/// demand. Bullet's own memory comes from malloc and is not affected.
namespace polhode::testing {

/// Returns the number of allocations since the start.
std::size_t heap_allocations();
/// Returns the number of allocations that have not been freed.
std::size_t heap_blocks();

enum class MemoryReturns { at_once, when_told };

/// During the lifetime of this object, the first `granted` allocations succeed and the next one throws
/// std::bad_alloc. With MemoryReturns::when_told all later ones throw too.
class MemoryShortage {
 public:
  MemoryShortage(std::size_t granted, MemoryReturns returns);
  ~MemoryShortage();
  MemoryShortage(const MemoryShortage&) = delete;
  MemoryShortage& operator=(const MemoryShortage&) = delete;

  /// Ends the shortage. Returns true if an allocation failed.
  bool end();
};

}  // namespace polhode::testing
