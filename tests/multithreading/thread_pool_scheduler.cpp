#include "multithreading/thread_pool_scheduler.h"

#include <algorithm>
#include <numeric>

namespace polhode::testing {

namespace {

// True while this thread runs a part of a loop.
thread_local bool in_loop = false;

int chunk_count(int begin, int end, int grain) {
  return (end - begin + grain - 1) / grain;
}

}  // namespace

ThreadPoolScheduler::ThreadPoolScheduler(int threads) : btITaskScheduler("thread pool"), threads_(threads) {
  for (int thread = 1; thread < threads; ++thread) workers_.emplace_back([this, thread] { work(thread); });
}

ThreadPoolScheduler::~ThreadPoolScheduler() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPoolScheduler::parallelFor(int begin, int end, int grain, const btIParallelForBody& body) {
  const bool done = run(chunk_count(begin, end, grain), [&](int chunk) {
    const int from = begin + chunk * grain;
    body.forLoop(from, std::min(from + grain, end));
  });
  if (!done) body.forLoop(begin, end);
}

// Adds the chunks in order, so that the sum does not depend on the threads.
btScalar ThreadPoolScheduler::parallelSum(int begin, int end, int grain, const btIParallelSumBody& body) {
  std::vector<btScalar> sums(static_cast<std::size_t>(std::max(chunk_count(begin, end, grain), 0)));
  const auto add_chunk = [&](int chunk) {
    const int from = begin + chunk * grain;
    sums[static_cast<std::size_t>(chunk)] = body.sumLoop(from, std::min(from + grain, end));
  };
  if (!run(static_cast<int>(sums.size()), add_chunk)) {
    for (int chunk = 0; chunk < static_cast<int>(sums.size()); ++chunk) add_chunk(chunk);
  }
  return std::accumulate(sums.begin(), sums.end(), btScalar(0));
}

// Returns true if the chunks were run.
bool ThreadPoolScheduler::run(int chunks, const Chunk& chunk) {
  if (chunks <= 0) return true;
  if (in_loop || !one_loop_.try_lock()) return false;
  const std::lock_guard<std::mutex> is_mine(one_loop_, std::adopt_lock);
  std::uint64_t loop = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    loop = ++loop_;
    chunks_ = chunks;
    chunk_ = &chunk;
    workers_at_work_ = threads_ - 1;
  }
  changed_.notify_all();
  run_share(0, loop, chunks, chunk);
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return workers_at_work_ == 0; });
  return true;
}

void ThreadPoolScheduler::run_share(int thread, std::uint64_t loop, int chunks, const Chunk& chunk) const {
  in_loop = true;
  const int first = static_cast<int>((static_cast<std::uint64_t>(thread) + loop) % threads_);
  for (int i = first; i < chunks; i += threads_) chunk(i);
  in_loop = false;
}

void ThreadPoolScheduler::work(int thread) {
  std::uint64_t done = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return closing_ || loop_ != done; });
    if (closing_) return;
    done = loop_;
    const int chunks = chunks_;
    const Chunk& chunk = *chunk_;
    lock.unlock();
    run_share(thread, done, chunks, chunk);
    lock.lock();
    if (--workers_at_work_ == 0) changed_.notify_all();
  }
}

}  // namespace polhode::testing
