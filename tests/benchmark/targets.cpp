#include "benchmark/targets.h"

#include "benchmark/paired_times.h"

namespace polhode::benchmarks {

namespace {

struct SizeLimit {
  const char* count;
  const char* benchmark;
  double ratio;
};

constexpr SizeLimit kFreeLimits[] = {
    {"1,000", "free/1000", 0.50},
    {"10,000", "free/10000", 0.65},
    {"100,000", "free/100000", 0.75},
};

// `exact` and the schemes of the exercise.
constexpr const char* kSchemes[] = {"exact", "matrix", "quaternion", "semi_implicit_gyroscopic",
                                    "implicit_gyroscopic"};

const char kEveryFreeWorld[] = "(world|plugin)/[a-z_0-9]+/(free|kicked)/[0-9]+";
// Only large worlds: a world's working space of about 30 KB would distort the memory per body.
const char kLargeFreeWorld[] = "(world|plugin)/[a-z_0-9]+/(free|kicked)/[0-9]{5,}";

}  // namespace

std::vector<Target> targets() {
  using counters::kRatio;
  std::vector<Target> rows;
  for (const char* scheme : kSchemes) {
    for (const SizeLimit& limit : kFreeLimits) {
      rows.push_back({std::string("RotationWorld, ") + scheme + ", " + limit.count + " free bodies",
                      std::string("world/") + scheme + "/" + limit.benchmark, kRatio, limit.ratio});
    }
  }
  rows.insert(
      rows.end(),
      {{"RotationWorld, exact, 10,000 bodies kicked in every step", "world/exact/kicked/10000", kRatio, 0.85},
       {"RotationWorld, exact, settled pile of 2,000, awake", "world/exact/pile/2000", kRatio, 1.00},
       {"RotationPlugin, exact, 10,000 free bodies", "plugin/exact/free/10000", kRatio, 1.05},
       {"kernel: exact, free / Bullet's implicit term and turn", "kernel/exact/free", kRatio, 0.20},
       {"kernel: exact with set-up / the same of Bullet", "kernel/exact/set_up", kRatio, 0.80},
       {"bytes per managed body, of 10,000 or more", kLargeFreeWorld, counters::kBytesPerBody, 384.0},
       {"allocations per step after warm-up", kEveryFreeWorld, counters::kAllocationsPerStep, 0.0},
       {"control: plain Bullet / itself, 10,000 free bodies", "control/bullet/free/10000", kRatio, {}},
       {"control: Bullet's kernel / itself", "kernel/bullet", kRatio, {}}});
  return rows;
}

std::string benchmarks_of(const std::vector<Target>& targets) {
  std::string names;
  for (const Target& target : targets) {
    // The same benchmarks report the other counters.
    if (target.counter == counters::kRatio) names += (names.empty() ? "" : "|") + target.benchmark;
  }
  return "^(" + names + ")/iterations";
}

}  // namespace polhode::benchmarks
