#include "support/counted_heap.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> frees{0};
// Number of the first allocation that fails.
std::atomic<std::size_t> first_refused{kNever};
std::atomic<std::size_t> end_of_refused{kNever};
std::atomic<bool> has_refused{false};

void count_allocation() {
  const std::size_t number = allocations++;
  if (number < first_refused || number >= end_of_refused) return;
  ++frees;
  has_refused = true;
  throw std::bad_alloc();
}

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void free_counted(void* memory) {
  if (memory != nullptr) ++frees;
  std::free(memory);
}

}  // namespace

// The other forms of new and delete call these. Not inlined: GCC would see only one of a pair and warn of a
// mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  count_allocation();
  return counted(std::malloc(size));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  count_allocation();
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  free_counted(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  free_counted(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  free_counted(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/,
                                       std::align_val_t /*alignment*/) noexcept {
  free_counted(memory);
}

namespace polhode::testing {

std::size_t heap_allocations() {
  return allocations;
}

std::size_t heap_blocks() {
  return allocations - frees;
}

MemoryShortage::MemoryShortage(std::size_t granted, MemoryReturns returns) {
  has_refused = false;
  end_of_refused = returns == MemoryReturns::at_once ? allocations + granted + 1 : kNever;
  first_refused = allocations + granted;
}

MemoryShortage::~MemoryShortage() {
  end();
}

bool MemoryShortage::end() {
  first_refused = kNever;
  return has_refused;
}

}  // namespace polhode::testing
