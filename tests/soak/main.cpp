// Steps worlds for a long time and checks that nothing grows or drifts: `polhode_soak STEPS`. A small world
// takes STEPS steps; a world of 1,000 changing bodies takes a tenth of them. Exits with 1 on a violation.
#include <cstdio>
#include <cstdlib>

#include "benchmark/heap_count.h"
#include "soak/soak_run.h"

int main(int argument_count, char** arguments) {
  // Rounded down, so that checkpoints divide the steps evenly.
  const long long steps = argument_count == 2 ? std::atoll(arguments[1]) / 1000 * 1000 : 0;
  if (steps < 1000) {
    std::fprintf(stderr, "polhode_soak: expected one argument: the number of steps, at least 1000\n");
    return 2;
  }
  polhode::benchmarks::count_heap_of_bullet();
  std::printf("%-15s %10s %8s %12s %14s %10s %10s\n", "", "steps", "managed", "heap bytes", "resident MiB",
              "energy", "L");
  const bool small_world_passed = polhode::testing::soak_small_world(steps);
  const bool changing_world_passed = polhode::testing::soak_changing_world(steps / 10);
  return small_world_passed && changing_world_passed ? 0 : 1;
}
