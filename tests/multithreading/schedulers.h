#pragma once

#include <LinearMath/btThreads.h>

#include <memory>
#include <string>
#include <vector>

namespace polhode::testing {

/// Sets the scheduler of btParallelFor during the lifetime of this object. Create at most one at a time, in
/// the main thread.
class ActiveScheduler {
 public:
  explicit ActiveScheduler(std::shared_ptr<btITaskScheduler> scheduler) : scheduler_(std::move(scheduler)) {
    btSetTaskScheduler(scheduler_.get());
  }
  ~ActiveScheduler() { btSetTaskScheduler(nullptr); }
  ActiveScheduler(const ActiveScheduler&) = delete;
  ActiveScheduler& operator=(const ActiveScheduler&) = delete;

 private:
  std::shared_ptr<btITaskScheduler> scheduler_;
};

struct SchedulerChoice {
  std::string name;
  std::shared_ptr<btITaskScheduler> (*make)();
};

/// Returns the single-threaded scheduler, the reference for all others.
const SchedulerChoice& one_thread();
const SchedulerChoice& four_threads();
/// Returns schedulers with 2, 3, 4 and 8 threads, Bullet's sequential scheduler, and Bullet's default one
/// with its default number of threads.
const std::vector<SchedulerChoice>& other_schedulers();

}  // namespace polhode::testing
