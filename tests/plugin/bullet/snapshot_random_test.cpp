// Random worlds with random actions of an application: repeating them after restoring gives the same bits.
#include <gtest/gtest.h>

#include <random>

#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"
#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);
constexpr int kBodies = 14;

btVector3 random_vector(std::mt19937& random, double size) {
  const double x = uniform(random, -size, size), y = uniform(random, -size, size);
  return vector(x, y, uniform(random, -size, size));
}

template <class Way>
void build(Way& way, unsigned seed) {
  std::mt19937 random(seed);
  set_gravity(way);
  way.world().getDispatchInfo().m_deterministicOverlappingPairs = seed % 2 == 0;
  way.world().setForceUpdateAllAabbs(seed % 3 != 0);
  way.add_floor().setFriction(btScalar(0.6));
  auto& compound = way.template shape<btCompoundShape>();
  for (const double side : {-0.4, 0.4}) {
    compound.addChildShape(btTransform(btQuaternion::getIdentity(), vector(side, 0.1, 0)),
                           &way.box(vector(0.3, 0.2, 0.2)));
  }
  btCollisionShape* const shapes[] = {&compound, &way.template shape<btSphereShape>(btScalar(0.3)),
                                      &way.template shape<btCylinderShape>(vector(0.3, 0.2, 0.3)),
                                      &way.box(vector(0.3, 0.2, 0.4))};
  for (int i = 0; i < kBodies; ++i) {
    btCollisionShape& shape = *shapes[random() % 4];
    btVector3 inertia_B;
    shape.calculateLocalInertia(1, inertia_B);
    const btTransform pose(btQuaternion(1, 2, btScalar(i), 4).normalized(),
                           random_vector(random, 1) + vector(0, 0, 1.5 + 0.4 * i));
    btRigidBody& body = way.add(1, inertia_B, pose, shape);
    body.setAngularVelocity(random_vector(random, 5));
    body.forceActivationState(ACTIVE_TAG);
    body.setAngularFactor(random() % 5 == 0 ? btVector3(1, 0, 1) : btVector3(1, 1, 1));
    way.rotation().set_scheme(body, built_in_schemes()[random() % built_in_schemes().size()]);
  }
  for (int i = 0; i < 4; ++i) {
    btRigidBody& a = *way.bodies()[1 + random() % kBodies];
    btRigidBody& b = *way.bodies()[1 + random() % kBodies];
    if (&a != &b) way.template join<btPoint2PointConstraint>(a, b, vector(0.4, 0, 0), vector(-0.4, 0, 0));
  }
}

// Changes the state of a body between two steps.
template <class Way>
void act(Way& way, std::mt19937& random) {
  btRigidBody& body = *way.bodies()[1 + random() % kBodies];
  const btVector3 numbers = random_vector(random, 2);
  switch (random() % 9) {
    case 0:
      body.activate();
      body.applyTorqueImpulse(numbers);
      break;
    case 1:
      body.applyTorque(numbers);
      break;
    case 2:
      body.setLinearVelocity(numbers);
      break;
    case 3:
      body.setAngularVelocity(numbers);
      break;
    case 4:
      body.setCenterOfMassTransform(btTransform(
          btQuaternion(numbers.x(), numbers.y(), numbers.z(), 3).normalized(), numbers + vector(0, 0, 3)));
      break;
    case 5:
      body.forceActivationState(random() % 2 == 0 ? ACTIVE_TAG : ISLAND_SLEEPING);
      break;
    case 6:
      way.rotation().set_scheme(body, built_in_schemes()[random() % built_in_schemes().size()]);
      break;
    case 7:
      if (way.rotation().manages(body))
        way.rotation().set_rotation(body, exponential(to_double(numbers)), to_double(numbers));
      break;
    default:
      way.rotation().release(body);
  }
}

template <class Way>
std::vector<std::uint64_t> play(Way& way, unsigned seed, int steps) {
  std::mt19937 random(seed);
  std::vector<std::uint64_t> digests;
  for (int step = 0; step < steps; ++step) {
    if (random() % 6 == 0) act(way, random);
    way.step(kStep);
    digests.push_back(digest_of(way.world(), way.rotation()));
  }
  return digests;
}

template <class Way>
class RandomWorldSnapshot : public ::testing::Test {};
TYPED_TEST_SUITE(RandomWorldSnapshot, BothWays, WayName);

TYPED_TEST(RandomWorldSnapshot, GoesOnWithTheSameBits) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    TypeParam way;
    build(way, seed);
    play(way, seed, static_cast<int>(seed * 7));
    const Snapshot snapshot = way.rotation().save_world();
    const auto went_on = play(way, 1000 + seed, 150);
    way.rotation().restore_world(snapshot);
    EXPECT_TRUE(way.rotation().save_world() == snapshot) << seed;
    EXPECT_EQ(first_difference(went_on, play(way, 1000 + seed, 150)), 0) << seed;
    TypeParam twin;
    build(twin, seed);
    play(twin, 2000 + seed, 10);
    twin.rotation().restore_world(snapshot);
    EXPECT_EQ(first_difference(went_on, play(twin, 1000 + seed, 150)), 0) << seed << ", into a twin";
  }
}

}  // namespace
}  // namespace polhode::testing
