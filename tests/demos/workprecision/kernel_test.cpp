// The bare kernels do exactly what a world does to a free body.
#include "workprecision/kernel.h"

#include <gtest/gtest.h>

#include "workprecision/motion.h"
#include "world/scenario_world.h"

namespace polhode::demos {
namespace {

Scenario scenario_of(const FreeBody& body, double dt_s) {
  Scenario scenario;
  scenario.body.shape = Sphere{0.5};
  scenario.body.inertia_B = body.inertia_B;
  scenario.body.q_WB = body.q_WB;
  scenario.body.omega_W = body.omega_W;
  scenario.dt = dt_s;
  return scenario;
}

void expect_the_bits_of_a_world(const FreeBody& body, double dt_s) {
  for (const Contender& contender : all_contenders()) {
    if (std::holds_alternative<SchemePointer>(contender.method)) continue;
    ScenarioWorld world(scenario_of(body, dt_s), contender);
    const auto kernel = make_kernel(contender, body, dt_s);
    for (int step = 1; step <= 600; ++step) {
      world.step();
      kernel->run(1);
      const RotationState worlds = world.sample().value().state;
      ASSERT_EQ(kernel->state().R_WB, worlds.R_WB) << contender.name << " step " << step;
      ASSERT_EQ(kernel->state().omega_W, worlds.omega_W) << contender.name << " step " << step;
    }
    EXPECT_EQ(kernel->inertia_B(), world.inertia_B());
    EXPECT_EQ(kernel->dt_s(), world.dt_s());
  }
}

TEST(BulletKernel, HasTheBitsOfAWorldInATumble) {
  expect_the_bits_of_a_world(FreeBody(), 1.0 / 60.0);
}

TEST(BulletKernel, HasTheBitsOfAWorldFromAnyOrientation) {
  const FreeBody body{{0.4, 0.5, 0.8}, Quaternion(1.0, 2.0, -3.0, 4.0).normalized(), {-1.0, 0.5, 2.0}};
  expect_the_bits_of_a_world(body, 0.01);
}

TEST(BulletKernel, HasTheBitsOfAWorldPastTheCutsOfTurnAndTorque) {
  const FreeBody body{{1.0, 2.0, 3.0}, Quaternion::Identity(), {30.0, 40.0, 50.0}};
  expect_the_bits_of_a_world(body, 1.0 / 60.0);
}

TEST(BulletKernel, HasTheBitsOfAWorldPastTheLimitOfAMultibodysVelocity) {
  const FreeBody body{{1.0, 2.0, 3.0}, Quaternion::Identity(), {20.0, 120.0, -150.0}};
  expect_the_bits_of_a_world(body, 0.001);
}

TEST(Kernel, StartsOverWithTheSameBits) {
  for (const Contender& contender : all_contenders()) {
    const auto kernel = make_kernel(contender, FreeBody(), 1.0 / 60.0);
    kernel->run(40);
    const RotationState first = kernel->state();
    kernel->restart();
    kernel->run(40);
    EXPECT_EQ(kernel->state().q_WB.coeffs(), first.q_WB.coeffs()) << contender.name;
    EXPECT_EQ(kernel->state().omega_W, first.omega_W) << contender.name;
  }
}

TEST(Kernel, TakesInAKickInEveryStep) {
  for (const Contender& contender : all_contenders()) {
    if (!std::holds_alternative<SchemePointer>(contender.method)) continue;
    const auto free = make_kernel(contender, FreeBody(), 1.0 / 60.0);
    const auto kicked = make_kernel(contender, FreeBody(), 1.0 / 60.0, Kick::every_step);
    free->run(60);
    kicked->run(60);
    const double difference = (kicked->state().omega_W - free->state().omega_W).norm();
    EXPECT_GT(difference, 5e-12) << contender.name;  // measured 1.1e-11 to
    EXPECT_LT(difference, 1e-10) << contender.name;  // 2.6e-11: 60 kicks of 1.7e-13
  }
}

TEST(Motion, StopsWhereABodyIsNoLongerSound) {
  const auto kernel =
      make_kernel(find_contenders({"semi_implicit_gyroscopic"}).front(), FreeBody(), 1.0 / 15.0);
  const Motion motion = follow(*kernel, 1000);
  EXPECT_TRUE(motion.diverged);
  EXPECT_EQ(motion.steps, 67);
  EXPECT_GT(motion.worst_energy_error, 1e6);  // measured 8.7e12
}

}  // namespace
}  // namespace polhode::demos
