#include "benchmark/heap_count.h"

#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

polhode::benchmarks::HeapCount count;

constexpr std::size_t kAlignment = alignof(std::max_align_t);

// Stores the size in front of the block, at a distance that preserves the alignment.
std::size_t distance_of(std::size_t alignment) {
  return std::max(alignment, kAlignment);
}

void* allocate_aligned(std::size_t size, std::size_t alignment) {
  const std::size_t distance = distance_of(alignment);
  const std::size_t whole = (size + 2 * distance - 1) / distance * distance;
  auto* const memory = static_cast<std::byte*>(std::aligned_alloc(distance, whole));
  if (memory == nullptr) throw std::bad_alloc();
  new (memory) std::size_t(size);
  ++count.allocations;
  count.live_bytes += static_cast<std::int64_t>(size);
  return memory + distance;
}

void release_aligned(void* handed_out, std::size_t alignment) {
  if (handed_out == nullptr) return;
  std::byte* const memory = static_cast<std::byte*>(handed_out) - distance_of(alignment);
  count.live_bytes -= static_cast<std::int64_t>(*std::launder(reinterpret_cast<std::size_t*>(memory)));
  std::free(memory);
}

void* allocate(std::size_t size) {
  return allocate_aligned(size, kAlignment);
}

void release(void* memory) {
  release_aligned(memory, kAlignment);
}

}  // namespace

// The other forms of new and delete call these.
void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_aligned(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t alignment) noexcept {
  release_aligned(memory, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t alignment) noexcept {
  release_aligned(memory, static_cast<std::size_t>(alignment));
}

namespace polhode::benchmarks {

HeapCount heap_count() {
  return count;
}

void count_heap_of_bullet() {
  btAlignedAllocSetCustom(allocate, release);
}

}  // namespace polhode::benchmarks
