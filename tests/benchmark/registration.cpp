#include "benchmark/registration.h"

#include <benchmark/benchmark.h>

#include <string>

#include "benchmark/kernel_benchmark.h"
#include "benchmark/world_benchmark.h"

namespace polhode::benchmarks {

namespace {

struct Size {
  std::size_t boxes;
  WorldRounds rounds;
};

// A round takes 10 to 200 ms per side: long compared with an interruption by the scheduler, short compared
// with a slow phase of the machine. Each build runs for at most about 60 steps, after which `matrix` would be
// the first scheme to diverge.
constexpr Size kFreeSizes[] = {
    {100, {2, 3, 10, 3}},
    {1000, {24, 3, 15, 3}},
    {10000, {6, 9, 4, 4}},
    {100000, {2, 5, 2, 2}},
};
constexpr Size kKickedSizes[] = {{100, {2, 3, 10, 3}}, {10000, {6, 9, 4, 4}}};
constexpr Size kPileSizes[] = {{100, {2, 3, 3, 10}}, {2000, {2, 11, 3, 20}}};
constexpr Size kPluginSizes[] = {{100, {2, 3, 10, 3}}, {10000, {6, 9, 4, 4}}};

void add_world(const std::string& name, const WorldBenchmark& world_benchmark) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [world_benchmark](benchmark::State& state) { run_world_benchmark(state, world_benchmark); })
      ->Iterations(world_benchmark.rounds.rounds())
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

void add_free(const std::string& who, RotatedBy rotated_by, const SchemePointer& scheme, const Size& size) {
  add_world(who + "/free/" + std::to_string(size.boxes),
            {rotated_by, scheme, [boxes = size.boxes] { return free_flight(boxes); }, size.rounds});
}

void add_kicked(const std::string& who, RotatedBy rotated_by, const SchemePointer& scheme, const Size& size) {
  add_world(who + "/kicked/" + std::to_string(size.boxes),
            {rotated_by, scheme, [boxes = size.boxes] { return free_flight(boxes); }, size.rounds, true});
}

void add_pile(const std::string& who, RotatedBy rotated_by, const SchemePointer& scheme, const Size& size) {
  add_world(who + "/pile/" + std::to_string(size.boxes),
            {rotated_by, scheme, [boxes = size.boxes] { return settled_pile(boxes); }, size.rounds});
}

void add_kernel(const std::string& name, const SchemePointer& scheme, KernelMotion motion) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [scheme, motion](benchmark::State& state) { run_kernel_benchmark(state, scheme, motion); })
      ->Iterations(kKernelRounds)
      ->UseManualTime();
}

void add_scheme(const SchemePointer& scheme) {
  const std::string name(scheme->description().name);
  const std::string world = "world/" + name;
  const std::string plugin = "plugin/" + name;
  for (const Size& size : kFreeSizes) add_free(world, RotatedBy::rotation_world, scheme, size);
  for (const Size& size : kKickedSizes) add_kicked(world, RotatedBy::rotation_world, scheme, size);
  for (const Size& size : kPileSizes) add_pile(world, RotatedBy::rotation_world, scheme, size);
  for (const Size& size : kPluginSizes) add_free(plugin, RotatedBy::rotation_plugin, scheme, size);
  add_kernel("kernel/" + name + "/free", scheme, KernelMotion::free);
  add_kernel("kernel/" + name + "/set_up", scheme, KernelMotion::set_up);
}

}  // namespace

void register_benchmarks() {
  for (const SchemePointer& scheme : built_in_schemes()) add_scheme(scheme);
  for (const Size& size : kFreeSizes) add_free("control/bullet", RotatedBy::bullet, nullptr, size);
  add_kernel("kernel/bullet", nullptr, KernelMotion::free);
}

}  // namespace polhode::benchmarks
