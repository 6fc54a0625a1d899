#pragma once

#include <LinearMath/btThreads.h>

#include <memory>
#include <string>
#include <vector>

namespace polhode::testing {

/// Sets the scheduler that btParallelFor runs on while this object lives. At most one exists at a time, made
/// in the main thread.
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

/// Returns the scheduler of one thread, with which all others are compared.
const SchedulerChoice& one_thread();
const SchedulerChoice& four_threads();
/// 2, 3, 4 and 8 threads, Bullet's sequential scheduler, and its default one with as many threads as it has.
const std::vector<SchedulerChoice>& other_schedulers();

}  // namespace polhode::testing
