// A step allocates nothing after warm-up. Bullet's own memory comes from malloc and is not counted here.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/scene.h"

namespace {

// Counts the allocations of the whole executable.
std::size_t allocations = 0;

}  // namespace

// Not inlined: GCC would see one of a pair without the other, and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/,
                                       std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}

namespace polhode::testing {
namespace {

TEST(Step, AllocatesNothingAfterWarmUp) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  Scene<> attached;
  RotationPlugin plugin(attached.world());
  for (const SchemePointer& scheme : built_in_schemes()) {
    btRigidBody& in_world = subclassed.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    btRigidBody& with_plugin = attached.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    subclassed.world().rotation().set_scheme(in_world, scheme);
    plugin.rotation().set_scheme(with_plugin, scheme);
  }
  const auto step = [&](int count) {
    subclassed.step(btScalar(1.0 / 60.0), count);
    attached.step(btScalar(1.0 / 60.0), count);
  };
  step(3);
  const std::size_t before = allocations;
  step(50);
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace polhode::testing
