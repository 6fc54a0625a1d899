#include "workprecision/cell_workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace polhode::demos {

namespace {

/// Distributes cells to threads one by one. The place of a result does not depend on the thread that computes
/// it.
class CellQueue {
 public:
  CellQueue(const CellMap& map, const std::vector<std::int64_t>& cells)
      : map_(map), cells_(cells), results_(cells.size()) {}

  void work() {
    try {
      for (std::size_t i = next_++; i < cells_.size(); i = next_++) results_[i] = map_.computed(cells_[i]);
    } catch (...) {
      next_ = cells_.size();
      const std::lock_guard<std::mutex> lock(failure_mutex_);
      failure_ = std::current_exception();
    }
  }

  std::vector<CellResult> results() {
    if (failure_) std::rethrow_exception(failure_);
    return std::move(results_);
  }

 private:
  const CellMap& map_;
  const std::vector<std::int64_t>& cells_;
  std::vector<CellResult> results_;
  std::atomic<std::size_t> next_{0};
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
};

}  // namespace

std::size_t thread_count(std::int64_t wish, int ranks) {
  if (wish > 0) return static_cast<std::size_t>(wish);
  return ranks > 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
}

std::vector<CellResult> computed_by_threads(const CellMap& map, const std::vector<std::int64_t>& cells,
                                            std::size_t threads) {
  CellQueue queue(map, cells);
  std::vector<std::thread> helpers;
  try {
    while (helpers.size() + 1 < std::min(threads, cells.size())) helpers.emplace_back([&] { queue.work(); });
  } catch (const std::system_error&) {
    // No more threads available: the existing ones do the work.
  }
  queue.work();
  for (std::thread& helper : helpers) helper.join();
  return queue.results();
}

}  // namespace polhode::demos
