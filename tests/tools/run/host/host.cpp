// A user's program that steps worlds: host WHAT. Prints the ratio of the bodies' final to initial rotational
// energy.
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include "tools/run/host/other_worlds.h"
#include "tools/run/host/scene.h"

namespace polhode::run_test {

namespace {

void print_energy(double ratio) {
  std::printf("energy ratio %.17g\n", ratio);
}

void step_one_world() {
  TumblingWorld world;
  for (int i = 0; i < kSteps; ++i) world.step();
  print_energy(world.energy_ratio());
}

void step_two_worlds() {
  TumblingWorld a;
  TumblingWorld b;
  for (int i = 0; i < kSteps; ++i) {
    a.step();
    b.step();
  }
  print_energy(a.energy_ratio());
  print_energy(b.energy_ratio());
}

void remake_a_world_at_its_address() {
  alignas(TumblingWorld) static unsigned char room[sizeof(TumblingWorld)];
  for (int i = 0; i < 3; ++i) {
    auto* world = new (room) TumblingWorld;
    for (int step = 0; step < kSteps; ++step) world->step();
    print_energy(world->energy_ratio());
    world->~TumblingWorld();
  }
}

// Takes two substeps in each step; in the last step four are due, but only two are taken.
void step_in_substeps() {
  TumblingWorld world;
  for (int i = 0; i < kSteps; ++i) world.world().stepSimulation(2 * kDt, 2, kDt);
  world.world().stepSimulation(4 * kDt, 2, kDt);
  print_energy(world.energy_ratio());
}

// Destroyed after main, when it makes another world. The destructor is registered before those of libraries
// that are loaded at the first step, and therefore runs after them.
struct StepsAfterMain {
  TumblingWorld world;
  StepsAfterMain() = default;
  ~StepsAfterMain() {
    for (int i = 0; i < kSteps; ++i) world.step();
    print_energy(world.energy_ratio());
    step_one_world();
  }
  StepsAfterMain(const StepsAfterMain&) = delete;
  StepsAfterMain& operator=(const StepsAfterMain&) = delete;
};

void step_after_main() {
  static StepsAfterMain instance;
  instance.world.step();
}

void throw_through_a_step() {
  TumblingWorld world;
  world.world().setInternalTickCallback(
      [](btDynamicsWorld* /*world*/, btScalar /*dt*/) { throw std::runtime_error("from a tick callback"); });
  try {
    world.step();
  } catch (const std::runtime_error& error) {
    std::printf("caught: %s\n", error.what());
  }
}

void make_a_body_not_finite() {
  TumblingWorld world;
  world.step();
  world.world().getNonStaticRigidBodies()[0]->setAngularVelocity(btVector3(btScalar(NAN), 0, 0));
  world.step();
}

// The child process inherits the library's counts.
void fork_after_steps() {
  step_one_world();
  std::fflush(stdout);
  const pid_t other = fork();
  if (other == 0) std::exit(0);
  waitpid(other, nullptr, 0);
}

void do_what(const std::string& what) {
  if (what == "one") return step_one_world();
  if (what == "two") return step_two_worlds();
  if (what == "remade") return remake_a_world_at_its_address();
  if (what == "substeps") return step_in_substeps();
  if (what == "after-main") return step_after_main();
  if (what == "throwing") return throw_through_a_step();
  if (what == "forked") return fork_after_steps();
  if (what == "non-finite") return make_a_body_not_finite();
  if (what == "deformable") return print_energy(step_a_deformable_world());
  if (what == "own-islands") return print_energy(step_a_world_with_its_own_islands());
  if (what == "own-islands-later") return print_energy(step_a_world_that_gets_its_own_islands());
  if (what == "kinds") return print_energy(step_each_kind_of_world());
  if (what == "multibody") return step_a_multibody();
}

}  // namespace

}  // namespace polhode::run_test

int main(int argument_count, char** arguments) {
  using namespace polhode::run_test;
  const std::string what = argument_count > 1 ? arguments[1] : "";
  if (what == "arguments") {
    for (int i = 2; i < argument_count; ++i) std::printf("[%s]", arguments[i]);
    return 0;
  }
  do_what(what == "exit-3" || what == "killed" ? "one" : what);
  std::fflush(stdout);
  if (what == "killed") std::raise(SIGTERM);
  return what == "exit-3" ? 3 : 0;
}
