#pragma once

#include <LinearMath/btThreads.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace polhode::testing {

/// A scheduler of any number of threads, the caller's among them. Bullet's own has at most as many as the
/// machine has processors. Every thread gets its share of each loop, however slow it is, and another share in
/// the next loop, so that any dependence on which thread runs which part, or when, shows.
class ThreadPoolScheduler final : public btITaskScheduler {
 public:
  explicit ThreadPoolScheduler(int threads);
  ~ThreadPoolScheduler() override;
  ThreadPoolScheduler(const ThreadPoolScheduler&) = delete;
  ThreadPoolScheduler& operator=(const ThreadPoolScheduler&) = delete;

  int getMaxNumThreads() const override { return threads_; }
  int getNumThreads() const override { return threads_; }
  void setNumThreads(int /*threads*/) override {}
  void parallelFor(int begin, int end, int grain, const btIParallelForBody& body) override;
  btScalar parallelSum(int begin, int end, int grain, const btIParallelSumBody& body) override;

 private:
  using Chunk = std::function<void(int chunk)>;

  bool run(int chunks, const Chunk& chunk);
  void run_share(int thread, std::uint64_t loop, int chunks, const Chunk& chunk) const;
  void work(int thread);

  const int threads_;
  std::mutex one_loop_;  // a loop within a loop, or in another thread, is run by its caller alone
  std::mutex mutex_;     // of all below
  std::condition_variable changed_;
  std::uint64_t loop_ = 0;
  int chunks_ = 0;
  const Chunk* chunk_ = nullptr;
  int workers_at_work_ = 0;
  bool closing_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace polhode::testing
