#pragma once

#include <LinearMath/btThreads.h>

#include <cstddef>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Whether the application has given Bullet a task scheduler, as a btDiscreteDynamicsWorldMt needs one, and
/// this is not one of its tasks: they do not nest.
inline bool bullet_has_threads() {
  const btITaskScheduler* scheduler = btGetTaskScheduler();
  return scheduler != nullptr && scheduler->getNumThreads() > 1 && !btThreadsAreRunning();
}

/// `function(first, last)` for parts of [0, count) that together are all of it: on the threads of Bullet's
/// task scheduler if it has any, else here in one part.
template <class Function>
void for_parts(std::size_t count, const Function& function) {
  struct Body final : btIParallelForBody {
    explicit Body(const Function& called) : function(called) {}
    void forLoop(int first, int last) const override {
      function(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
    }
    const Function& function;
  };
  // Long enough that handing it to a thread does not show, short enough that the threads end together.
  constexpr int kBodiesInPart = 256;
  if (count > kBodiesInPart && bullet_has_threads()) {
    btParallelFor(0, static_cast<int>(count), kBodiesInPart, Body(function));
  } else if (count > 0) {
    function(0, count);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
