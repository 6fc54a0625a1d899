#pragma once

#include <LinearMath/btThreads.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace polhode::testing {

/// A scheduler with any number of threads, including the calling one; Bullet's own has at most one thread per
/// processor. Every thread runs its share of each loop, however slow the thread is, and a different share in
/// the next loop. This exposes any dependence on which thread runs which part, or when.
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
  std::mutex one_loop_;  // held by a loop; nested and concurrent loops run in their callers
  std::mutex mutex_;     // protects the members below
  std::condition_variable changed_;
  std::uint64_t loop_ = 0;
  int chunks_ = 0;
  const Chunk* chunk_ = nullptr;
  int workers_at_work_ = 0;
  bool closing_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace polhode::testing
