// Prints the hashes of the golden scene in a RotationWorld and under a RotationPlugin, for each number of
// threads: `golden_hash [THREADS...]`. The last line is for scripts: the hash for btDiscreteDynamicsWorld and
// the hash for btDiscreteDynamicsWorldMt. Exits with 1 if a hash differs from the golden one.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "determinism/golden_hashes.h"
#include "multithreading/thread_pool_scheduler.h"

namespace polhode::testing {
namespace {

std::string text_of(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, hash);
  return text;
}

void print(const char* way, int threads, std::uint64_t hash) {
  std::printf("%-34s %d threads  %s\n", way, threads, text_of(hash).c_str());
}

/// The hashes found in worlds of one class.
class Hashes {
 public:
  void add(const char* way, int threads, std::uint64_t hash) {
    print(way, threads, hash);
    hashes_.insert(hash);
  }
  std::string text() const { return hashes_.size() == 1 ? text_of(*hashes_.begin()) : "differs"; }
  bool are(std::uint64_t golden) const { return hashes_ == std::set<std::uint64_t>{golden}; }

 private:
  std::set<std::uint64_t> hashes_;
};

bool print_hashes(const std::vector<int>& thread_counts) {
  const std::uint64_t plain = hash_in_plain_bullet<btDiscreteDynamicsWorld>();
  print("plain Bullet", 1, plain);
  if (plain != kGoldenOfPlainBullet) std::printf("Bullet or the C library differs from Debian 12's\n");
  Hashes discrete, discrete_mt;
  discrete.add("RotationPlugin", 1, hash_under_rotation_plugin<btDiscreteDynamicsWorld>());
  for (const int threads : thread_counts) {
    const auto scheduler = std::make_unique<ThreadPoolScheduler>(threads);
    btSetTaskScheduler(scheduler.get());
    discrete.add("RotationWorld", threads, hash_in_rotation_world<btDiscreteDynamicsWorld>());
    discrete_mt.add("RotationWorld, multithreaded", threads,
                    hash_in_rotation_world<btDiscreteDynamicsWorldMt>());
    discrete_mt.add("RotationPlugin, multithreaded", threads,
                    hash_under_rotation_plugin<btDiscreteDynamicsWorldMt>());
    btSetTaskScheduler(nullptr);
  }
  std::printf("%s %s\n", discrete.text().c_str(), discrete_mt.text().c_str());
  return discrete.are(kGolden.discrete) && discrete_mt.are(kGolden.discrete_mt);
}

}  // namespace
}  // namespace polhode::testing

int main(int argument_count, char** arguments) {
  std::vector<int> thread_counts;
  for (int i = 1; i < argument_count; ++i) thread_counts.push_back(std::atoi(arguments[i]));
  if (thread_counts.empty()) thread_counts.push_back(1);
  return polhode::testing::print_hashes(thread_counts) ? 0 : 1;
}
