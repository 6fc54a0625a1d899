#include "multithreading/schedulers.h"

#include <stdexcept>

#include "multithreading/thread_pool_scheduler.h"

namespace polhode::testing {

namespace {

template <int threads>
std::shared_ptr<btITaskScheduler> make_pool() {
  return std::make_shared<ThreadPoolScheduler>(threads);
}

// Bullet owns the scheduler.
std::shared_ptr<btITaskScheduler> bullets_sequential() {
  return {btGetSequentialTaskScheduler(), [](btITaskScheduler*) {}};
}

std::shared_ptr<btITaskScheduler> bullets_default() {
  std::shared_ptr<btITaskScheduler> scheduler(btCreateDefaultTaskScheduler());
  if (scheduler == nullptr) throw std::logic_error("the linked Bullet was not built thread-safe");
  scheduler->setNumThreads(scheduler->getMaxNumThreads());
  return scheduler;
}

}  // namespace

const SchedulerChoice& one_thread() {
  static const SchedulerChoice choice{"one thread", make_pool<1>};
  return choice;
}

const SchedulerChoice& four_threads() {
  static const SchedulerChoice choice{"four threads", make_pool<4>};
  return choice;
}

const std::vector<SchedulerChoice>& other_schedulers() {
  static const std::vector<SchedulerChoice> choices{
      {"Bullet's sequential scheduler", bullets_sequential},
      {"Bullet's default scheduler", bullets_default},
      {"two threads", make_pool<2>},
      {"three threads", make_pool<3>},
      four_threads(),
      {"eight threads", make_pool<8>},
  };
  return choices;
}

}  // namespace polhode::testing
