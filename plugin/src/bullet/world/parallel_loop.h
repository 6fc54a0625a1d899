#pragma once

#include <LinearMath/btThreads.h>

#include <cstddef>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns true if the application has given Bullet a task scheduler, as btDiscreteDynamicsWorldMt requires,
/// and the caller is not one of its tasks, which cannot be nested.
inline bool bullet_has_threads() {
  const btITaskScheduler* scheduler = btGetTaskScheduler();
  return scheduler != nullptr && scheduler->getNumThreads() > 1 && !btThreadsAreRunning();
}

/// Calls function(first, last) for consecutive parts of [0, count), on the threads of Bullet's task
/// scheduler. Makes one call on this thread if there is no scheduler. `grain` is the longest part for a
/// thread.
template <class Function>
void for_parts(std::size_t count, int grain, const Function& function) {
  struct Body final : btIParallelForBody {
    explicit Body(const Function& called) : function(called) {}
    void forLoop(int first, int last) const override {
      function(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
    }
    const Function& function;
  };
  if (count > static_cast<std::size_t>(grain) && bullet_has_threads()) {
    btParallelFor(0, static_cast<int>(count), grain, Body(function));
  } else if (count > 0) {
    function(0, count);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
