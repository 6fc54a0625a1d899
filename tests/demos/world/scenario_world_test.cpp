#include "world/scenario_world.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/scenario_file.h"
#include "demos/world/contender.h"
#include "polhode/rotation_math.h"
#include "world/conversions.h"
#include "world/scenario_body.h"

namespace polhode::demos {
namespace {

// The relative error of a number of the scenario in Bullet's precision.
const double kRounding = static_cast<double>(SIMD_EPSILON);

const btRigidBody& rigid_body(const btCollisionObject& object) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr) throw std::logic_error("it is no rigid body");
  return *body;
}

const btMultiBody& multibody(const btCollisionObject& object) {
  const btMultiBodyLinkCollider* collider = btMultiBodyLinkCollider::upcast(&object);
  if (collider == nullptr) throw std::logic_error("it is no collider of a multibody");
  return *collider->m_multiBody;
}

Vector3 omega_W(const btCollisionObject& object) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  return from_bullet(body != nullptr ? body->getAngularVelocity() : multibody(object).getBaseOmega());
}

class EveryContender : public testing::TestWithParam<std::string> {};

std::vector<std::string> every_name() {
  const std::vector<Contender> all = all_contenders();
  std::vector<std::string> names(all.size());
  std::transform(all.begin(), all.end(), names.begin(), [](const Contender& each) { return each.name; });
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), ':', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Each, EveryContender, testing::ValuesIn(every_name()), test_name);

TEST_P(EveryContender, StartsWhereTheScenarioSays) {
  const Scenario scenario = scenario_file("heavy_top");
  const Sample start = ScenarioWorld(scenario, contender(GetParam())).sample().value();
  const Body& body = scenario.body;
  EXPECT_EQ(start.step, 0);
  EXPECT_EQ(start.t_s, 0.0);
  // Measured, single and double: 0.12 and 0.5 of the rounding for q, 0.35 and 0 for omega, 0.16 and 0.8 for
  // L, 0.3 and 0 for the energy.
  EXPECT_LT(start.state.q_WB.angularDistance(body.q_WB), 2 * kRounding);
  EXPECT_LT((start.state.omega_W - body.omega_W).norm(), kRounding * body.omega_W.norm());
  const Vector3 L_W = body.q_WB * body.inertia_B->cwiseProduct(body.q_WB.conjugate() * body.omega_W);
  EXPECT_LT((start.state.L_W - L_W).norm(), 2 * kRounding * L_W.norm());
  const double energy_J =
      0.5 * body.omega_W.dot(L_W) + 0.5 * body.velocity_W.squaredNorm() + 9.81 * body.position_W.z();
  EXPECT_NEAR(start.energy_J, energy_J, kRounding * energy_J);
}

TEST_P(EveryContender, FallsAsGalileoSays) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 2, 3], "mass": 2, "position": [0, 0, 5], "linear_velocity": [3, 0, 0],
          "gravity": [0, 0, -10], "dt": 0.0625, "duration": 1})",
      "falling.json");
  ScenarioWorld world(scenario, contender(GetParam()));
  EXPECT_EQ(world.sample()->energy_J, 0.5 * 2 * 9 + 2 * 10 * 5);
  for (int step = 0; step < 16; ++step) world.step();
  // Euler's steps: z = z0 - g dt^2 n (n + 1) / 2
  const Vector3 position_W = world.sample()->position_W;
  EXPECT_LT((position_W - Vector3(3, 0, 5 - 10 * 0.0625 * 0.0625 * 136)).norm(),
            1e-6);  // measured 0: every number is a binary fraction
  EXPECT_EQ(world.sample()->t_s, 1.0);
}

TEST_P(EveryContender, IsTurnedByTheScenariosTorque) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 2, 4], "torque": [0, 0, 2], "dt": 0.0625, "duration": 1})", "turned.json");
  ScenarioWorld world(scenario, contender(GetParam()));
  for (int step = 0; step < 16; ++step) world.step();
  EXPECT_LT((world.sample()->state.L_W - Vector3(0, 0, 2)).norm(),
            1e-5);  // measured 4.8e-7 in single, 0 in double
}

TEST_P(EveryContender, DoesNotFallAsleep) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 2, 3], "angular_velocity": [0, 0, 0.01], "dt": 0.5, "duration": 10})", "slow.json");
  ScenarioWorld world(scenario, contender(GetParam()));
  for (int step = 0; step < 20; ++step) world.step();
  EXPECT_NEAR(logarithm(world.sample()->state.q_WB).z(), 0.1, 1e-5);  // measured 8.4e-7: Euler turns
}

// The viewer draws the collider.
TEST(ScenarioWorld, HasAMultibodysColliderWhereTheSampleSays) {
  ScenarioWorld world(scenario_file("heavy_top"), contender("bullet:multibody"));
  for (int step = 0; step < 10; ++step) {
    const btTransform& pose_WB = world.body().getWorldTransform();
    const Sample sample = world.sample().value();
    EXPECT_EQ(from_bullet(pose_WB.getOrigin()), sample.position_W) << step;
    EXPECT_LT((from_bullet(pose_WB.getBasis()) - sample.state.R_WB).norm(), 4 * kRounding)
        << step;  // measured 0.52 of the rounding in single, 1.9 in double
    world.step();
  }
}

TEST_P(EveryContender, LetsABodyLeaveItsWorld) {
  ContenderWorld world(contender(GetParam()));
  auto body = make_scenario_body(world, scenario_file("heavy_top").body);
  body->pin({0, 0, -0.05});
  btMultiBodyDynamicsWorld* multibodies = world.multibody_world();
  const auto constraints = [&] {
    return world.world().getNumConstraints() +
           (multibodies == nullptr ? 0 : multibodies->getNumMultiBodyConstraints());
  };
  EXPECT_EQ(world.world().getNumCollisionObjects(), 1);
  EXPECT_EQ(constraints(), 1);
  body.reset();
  ASSERT_EQ(world.world().getNumCollisionObjects(), 0);
  ASSERT_EQ(constraints(), 0);
  if (multibodies != nullptr) {
    ASSERT_EQ(multibodies->getNumMultibodies(), 0);
  }
  world.world().stepSimulation(btScalar(1) / 60, 0);
}

TEST(ScenarioWorld, GivesABulletContenderExactlyItsFlag) {
  const Scenario scenario = scenario_file("tumble");
  const auto flags = [&](const char* name) {
    return rigid_body(ScenarioWorld(scenario, contender(name)).body()).getFlags();
  };
  EXPECT_EQ(flags("bullet:none"), 0);
  EXPECT_EQ(flags("bullet:explicit"), BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);
  EXPECT_EQ(flags("bullet:implicit_world"), BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD);
  EXPECT_EQ(flags("bullet:implicit_body"), BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
  EXPECT_EQ(flags("matrix"), BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) << "as Bullet makes a body";
}

TEST(ScenarioWorld, ReBasesACompoundToItsPrincipalAxes) {
  const Scenario scenario = resolved(scenario_file("t_handle"));
  const Vector3& inertia_B = *scenario.body.inertia_B;
  EXPECT_LT(inertia_B.y(), inertia_B.x()) << "x is the middle axis";
  EXPECT_LT(inertia_B.x(), inertia_B.z()) << "x is the middle axis";
  EXPECT_EQ(scenario.body.omega_W, Vector3(10, 0.1, 0));
  EXPECT_EQ(scenario.dt, 1.0 / 60.0);
  // Computed by hand: a bar of 1 kg, half extents 0.5, 0.1, 0.1, and a stem of 0.8 kg, 0.1, 0.4, 0.1, 0.5 m
  // apart.
  const double between = 1.0 * 0.8 / 1.8 * 0.25;
  const Vector3 by_hand((0.02 + 0.8 * 0.17) / 3.0 + between, (0.26 + 0.8 * 0.02) / 3.0,
                        (0.26 + 0.8 * 0.17) / 3.0 + between);
  EXPECT_LT((inertia_B - by_hand).norm(), 1e-7);  // measured 1.2e-8 in single
  // The centre of mass is the body's origin: 0.8 / 1.8 * 0.5 m below the bar.
  const ScenarioWorld world(scenario, contender("matrix"));
  const auto& shape = static_cast<const btCompoundShape&>(*world.body().getCollisionShape());
  EXPECT_NEAR(static_cast<double>(shape.getChildTransform(0).getOrigin().y()), 0.4 / 1.8,
              1e-7);  // measured 1.7e-8 in single
  EXPECT_NEAR(static_cast<double>(shape.getChildTransform(1).getOrigin().y()), 0.4 / 1.8 - 0.5,
              1e-7);  // measured 1.7e-8 in single
}

TEST(ScenarioWorld, HoldsATopByItsTip) {
  const Scenario scenario = scenario_file("heavy_top");
  for (const char* name : {"quaternion", "bullet:none", "bullet:multibody"}) {
    ScenarioWorld world(scenario, contender(name));
    for (int step = 0; step < 240; ++step) world.step();
    const Vector3 tip_W = from_bullet(world.body().getWorldTransform() * btVector3(0, 0, btScalar(-0.05)));
    EXPECT_LT(tip_W.norm(), 5e-4) << name;  // measured 1.3e-4 m
  }
}

// Bullet limits the impulse of a multibody's constraint by default; this constraint takes 400 N s a step.
TEST(ScenarioWorld, HoldsAHeavyMultibodyByItsPoint) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1e4, 1e4, 1e4], "mass": 1e4, "gravity": [0, 0, -9.81], "dt": 0.004, "duration": 1,
          "constraint": {"type": "point_to_point", "pivot_B": [0, 0, 0.5]}})",
      "heavy.json");
  ScenarioWorld world(scenario, contender("bullet:multibody"));
  for (int step = 0; step < 250; ++step) world.step();
  EXPECT_LT(world.sample()->position_W.norm(), 1e-3);  // measured 0
}

TEST(ScenarioWorld, LaysItsBodiesOnTheGround) {
  const Scenario scenario = scenario_file("floor");
  for (const char* name : {"implicit_gyroscopic", "bullet:multibody"}) {
    SCOPED_TRACE(name);
    ScenarioWorld world(scenario, contender(name));
    const auto steps = step_count(scenario.dt, scenario.duration);
    for (std::int64_t step = 0; step < steps; ++step) world.step();
    ASSERT_EQ(world.world().getNumCollisionObjects(), 4);
    for (std::size_t i = 0; i < 3; ++i) {
      const double height = static_cast<double>(world.body(i).getWorldTransform().getOrigin().z());
      EXPECT_GT(height, 0.09) << "body " << i;  // measured 0.1 and 0.2, lying flat
      EXPECT_LT(height, 0.21) << "body " << i;
      EXPECT_LT(omega_W(world.body(i)).norm(), 1e-3)
          << "body " << i;  // measured 1.1e-5, 6.5e-6 of multibodies
    }
  }
}

TEST(ScenarioWorld, HandsMaterialsAndIterationsToBullet) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 2, 3], "mass": 4, "friction": 0.25, "restitution": 0.75, "dt": 1, "duration": 1,
          "damping": {"linear": 0.125, "angular": 0.375}, "solver_iterations": 7,
          "ground": {"height": -5, "normal": [0, 1, 0], "friction": 2, "restitution": 0.5}})",
      "materials.json");
  ScenarioWorld world(scenario, contender("matrix"));
  EXPECT_EQ(world.world().getSolverInfo().m_numIterations, 7);
  const btRigidBody& body = rigid_body(world.body());
  EXPECT_EQ(body.getMass(), btScalar(4));
  EXPECT_EQ(body.getFriction(), btScalar(0.25));
  EXPECT_EQ(body.getRestitution(), btScalar(0.75));
  EXPECT_EQ(body.getLinearDamping(), btScalar(0.125));
  EXPECT_EQ(body.getAngularDamping(), btScalar(0.375));
  const btCollisionObject& ground = *world.world().getCollisionObjectArray()[1];
  EXPECT_EQ(ground.getFriction(), btScalar(2));
  EXPECT_EQ(ground.getRestitution(), btScalar(0.5));
  const auto& plane = static_cast<const btStaticPlaneShape&>(*ground.getCollisionShape());
  EXPECT_EQ(from_bullet(plane.getPlaneNormal()), Vector3(0, 1, 0));
  EXPECT_EQ(plane.getPlaneConstant(), btScalar(-5));
}

TEST(ScenarioWorld, MakesEachBodyAMultibodyAsBulletHasIt) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 2, 3], "mass": 4, "friction": 0.25, "restitution": 0.75, "dt": 1, "duration": 1,
          "damping": {"linear": 0.125, "angular": 0.375}, "others": [{"inertia": [3, 2, 1]}]})",
      "materials.json");
  ScenarioWorld world(scenario, contender("bullet:multibody"));
  EXPECT_EQ(static_cast<btMultiBodyDynamicsWorld&>(world.world()).getNumMultibodies(), 2);
  const btMultiBody& first = multibody(world.body());
  EXPECT_EQ(first.getNumLinks(), 0);
  EXPECT_EQ(first.getBaseMass(), btScalar(4));
  EXPECT_EQ(from_bullet(first.getBaseInertia()), Vector3(1, 2, 3));
  EXPECT_EQ(from_bullet(multibody(world.body(1)).getBaseInertia()), Vector3(3, 2, 1));
  EXPECT_EQ(world.body().getFriction(), btScalar(0.25));
  EXPECT_EQ(world.body().getRestitution(), btScalar(0.75));
  EXPECT_EQ(first.getLinearDamping(), btScalar(0.125));
  EXPECT_EQ(first.getAngularDamping(), btScalar(0.375));
  EXPECT_TRUE(first.getUseGyroTerm());
  EXPECT_FALSE(first.getCanSleep());
}

// docs/compare.md says so.
TEST(ScenarioWorld, DampsAMultibodyTheMoreTheFasterItIs) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 1, 1], "linear_velocity": [3, 0, 0], "angular_velocity": [0, 0, 7],
          "damping": {"linear": 0.5, "angular": 0.25}, "dt": 0.0625, "duration": 1})",
      "damped.json");
  ScenarioWorld world(scenario, contender("bullet:multibody"));
  world.step();
  // v - dt damping (1 + |v|) v: measured 0, every number is a binary fraction
  EXPECT_EQ(world.sample()->position_W, Vector3(0.0625 * (3 - 0.0625 * 0.5 * (1 + 3) * 3), 0, 0));
  EXPECT_EQ(world.sample()->state.omega_W, Vector3(0, 0, 7 - 0.0625 * 0.25 * (1 + 7) * 7));
}

// docs/compare.md says so.
TEST(ScenarioWorld, LeavesAMultibodyBulletsLimitOfItsVelocity) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1, 1, 1], "linear_velocity": [150, 0, 50], "angular_velocity": [0, 30, -120],
          "dt": 0.0625, "duration": 1})",
      "fast.json");
  ScenarioWorld world(scenario, contender("bullet:multibody"));
  EXPECT_EQ(world.sample()->state.omega_W, Vector3(0, 30, -120)) << "the start is not yet a step's";
  world.step();
  EXPECT_EQ(world.sample()->state.omega_W, Vector3(0, 30, -100));
  EXPECT_EQ(world.sample()->position_W, Vector3(0.0625 * 100, 0, 0.0625 * 50));
}

TEST(ScenarioWorld, LetsMultibodiesCollideWithEachOther) {
  const Scenario scenario = parse_scenario(
      R"({"shape": {"type": "sphere", "radius": 0.5}, "restitution": 1, "friction": 0,
          "linear_velocity": [2, 0, 0], "dt": 0.015625, "duration": 1,
          "others": [{"shape": {"type": "sphere", "radius": 0.5}, "restitution": 1, "friction": 0,
                      "position": [1.5, 0, 0]}]})",
      "spheres.json");
  ScenarioWorld world(scenario, contender("bullet:multibody"));
  for (int step = 0; step < 64; ++step) world.step();
  const double first_m_s = static_cast<double>(multibody(world.body()).getBaseVel().x());
  const double second_m_s = static_cast<double>(multibody(world.body(1)).getBaseVel().x());
  EXPECT_NEAR(first_m_s, 0.0, 1e-5);   // measured 0
  EXPECT_NEAR(second_m_s, 2.0, 1e-5);  // measured 0
}

TEST(DrawnBody, IsTheShapeInTheBodysAxes) {
  const auto drawn = [](const std::string& shape) {
    return drawn_body(
        parse_scenario(R"({"dt": 1, "duration": 1, "shape": )" + shape + "}", "shape.json").body);
  };
  EXPECT_EQ(drawn(R"({"type": "sphere", "radius": 0.5})").radius, 0.5);
  const DrawnBody box = drawn(R"({"type": "box", "half_extents": [1, 2, 3]})");
  ASSERT_EQ(box.boxes.size(), 1u);
  EXPECT_EQ(box.boxes[0].half_extents, Vector3(1, 2, 3));
  EXPECT_TRUE(box.boxes[0].at_B.isZero(0.0));
  // A dumb-bell along x whose left end is three times as heavy.
  const DrawnBody bell = drawn(R"({"type": "compound", "parts": [
      {"half_extents": [0.1, 0.2, 0.3], "at": [-1, 0, 0], "mass": 3},
      {"half_extents": [0.1, 0.2, 0.3], "at": [1, 0, 0], "mass": 1}]})");
  ASSERT_EQ(bell.boxes.size(), 2u);
  EXPECT_NEAR(bell.boxes[0].at_B.norm(), 0.5, 1e-6);  // measured 0
  EXPECT_NEAR(bell.boxes[1].at_B.norm(), 1.5, 1e-6);
  EXPECT_NEAR((bell.boxes[0].at_B - bell.boxes[1].at_B).norm(), 2.0, 1e-6);
  EXPECT_NEAR((bell.boxes[0].half_extents - Vector3(0.1, 0.2, 0.3)).norm(), 0.0, 1e-6);  // measured 1.1e-8
}

TEST(ScenarioWorld, RefusesAStartThatCannotBeRun) {
  const Scenario fast = parse_scenario(
      R"({"inertia": [1e-9, 1, 1], "impulses": [{"impulse": [0, 0, 1e9], "at": [0, 1, 0]}], "dt": 1, "duration": 1})",
      "fast.json");
  EXPECT_THAT([&] { resolved(fast); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("valid is at most 1e+09")));
  const Scenario tiny = parse_scenario(
      R"({"shape": {"type": "sphere", "radius": 1e-6}, "mass": 1e-9, "dt": 1, "duration": 1})", "tiny.json");
  EXPECT_THAT([&] { resolved(tiny); }, testing::ThrowsMessage<std::invalid_argument>(
                                           testing::HasSubstr("\"shape\": its principal moments")));
}

}  // namespace
}  // namespace polhode::demos
