// A RotationWorld integrates some bodies itself and leaves the others to Bullet.
#include <LinearMath/btTransformUtil.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/precision.h"
#include "support/same_body_bits.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);

// Interleaves bodies of every kind, so that the world's list is cut into many pieces.
template <class World>
void add_bodies_of_all_kinds(Scene<World>& scene) {
  for (int i = 0; i < 24; ++i) {
    const auto number = static_cast<btScalar>(i);
    btRigidBody& body = scene.add_free(btVector3(1, 2 + number / 10, 3), btVector3(3, 2 - number / 5, 4));
    body.setLinearVelocity(btVector3(number / 7, -1, 2));
    switch (i % 8) {
      case 1:
        body.setDamping(btScalar(0.2), btScalar(0.3));
        break;
      case 2:
        body.setCcdMotionThreshold(btScalar(0.01));
        body.setCcdSweptSphereRadius(btScalar(0.2));
        break;
      case 3:
        body.forceActivationState(ISLAND_SLEEPING);
        break;
      case 4:
        body.setAngularFactor(btVector3(1, 0, 1));
        break;
      case 5:
        body.setInvInertiaDiagLocal(btVector3(0, 1, btScalar(0.5)));
        break;
      default:
        break;
    }
  }
}

template <class World>
void choose_schemes(Scene<World>& scene, RotationControl& rotation) {
  for (std::size_t i = 0; i < scene.bodies().size(); ++i) {
    if (i % 8 == 6) rotation.release(*scene.bodies()[i]);
    if (i % 8 == 7) rotation.set_scheme(*scene.bodies()[i], "matrix");
  }
}

TEST(IntegratedBodies, BesideBulletsAreAsUnderAPlugin) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  add_bodies_of_all_kinds(subclassed);
  choose_schemes(subclassed, subclassed.world().rotation());
  Scene<> attached;
  RotationPlugin plugin(attached.world());
  add_bodies_of_all_kinds(attached);
  choose_schemes(attached, plugin.rotation());

  for (int step = 1; step <= 400; ++step) {
    subclassed.step(kStep);
    attached.step(kStep);
    for (std::size_t i = 0; i < attached.bodies().size(); ++i) {
      ASSERT_TRUE(same_bits(*subclassed.bodies()[i], *attached.bodies()[i]))
          << "body " << i << ", step " << step;
    }
  }
}

TEST(IntegratedBodies, LeaveBulletsBodiesTheirBits) {
  Scene<> plain;
  add_bodies_of_all_kinds(plain);
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  add_bodies_of_all_kinds(subclassed);
  choose_schemes(subclassed, subclassed.world().rotation());
  for (int step = 1; step <= 400; ++step) {
    plain.step(kStep);
    subclassed.step(kStep);
    for (std::size_t i = 6; i < plain.bodies().size(); i += 8) {
      ASSERT_TRUE(same_bits(*plain.bodies()[i], *subclassed.bodies()[i]))
          << "body " << i << ", step " << step;
    }
  }
}

TEST(IntegratedBodies, AreBackInTheWorldsListInItsOrder) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  add_bodies_of_all_kinds(scene);
  choose_schemes(scene, scene.world().rotation());
  scene.step(kStep, 3);
  const auto& list = scene.world().getNonStaticRigidBodies();
  ASSERT_EQ(list.size(), static_cast<int>(scene.bodies().size()));
  for (int i = 0; i < list.size(); ++i) EXPECT_EQ(list[i], scene.bodies()[static_cast<std::size_t>(i)].get());
}

// A change that an application may make between two steps.
template <class World>
void change(Scene<World>& scene, RotationControl& rotation, std::mt19937& random) {
  const std::size_t which = random() % scene.bodies().size();
  btRigidBody& body = *scene.bodies()[which];
  const auto number = static_cast<btScalar>(random() % 100) / 10;
  switch (random() % 9) {
    case 0:
      body.applyTorqueImpulse(btVector3(number, 0, 1));
      break;
    case 1:
      if (scene.bodies().size() > 5) scene.remove(body);
      break;
    case 2:
      scene.add_free(btVector3(1, 2, 3 + number), btVector3(number, 2, 4));
      break;
    case 3:
      rotation.release(body);
      break;
    case 4:
      rotation.use_default_scheme(body);
      break;
    case 5:
      rotation.set_scheme(body, "implicit_midpoint");
      break;
    case 6:
      body.setAngularVelocity(btVector3(1, number, 2));
      break;
    case 7:
      body.getWorldTransform().setRotation(btQuaternion(1, number, 2, 3).normalized());
      break;
    default:
      body.forceActivationState(number < 5 ? ISLAND_SLEEPING : DISABLE_DEACTIVATION);
      break;
  }
}

TEST(IntegratedBodies, FollowWhateverTheApplicationChanges) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
    Scene<> attached;
    RotationPlugin plugin(attached.world());
    add_bodies_of_all_kinds(subclassed);
    add_bodies_of_all_kinds(attached);
    std::mt19937 random_here(seed);
    std::mt19937 random_there(seed);
    for (int step = 1; step <= 300; ++step) {
      change(subclassed, subclassed.world().rotation(), random_here);
      change(attached, plugin.rotation(), random_there);
      subclassed.step(kStep);
      attached.step(kStep);
      ASSERT_EQ(subclassed.world().rotation().managed_bodies(), plugin.rotation().managed_bodies());
      for (std::size_t i = 0; i < attached.bodies().size(); ++i) {
        const btRigidBody& here = *subclassed.bodies()[i];
        const btRigidBody& there = *attached.bodies()[i];
        ASSERT_EQ(subclassed.world().rotation().manages(here), plugin.rotation().manages(there));
        ASSERT_TRUE(same_bits(here, there)) << "seed " << seed << ", body " << i << ", step " << step;
      }
    }
  }
}

TEST(IntegratedBodies, ShowTheirPoseToTheirMotionStates) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btDefaultMotionState motion_state;
  btRigidBody& body = scene.add(1, btVector3(1, 2, 3), btTransform::getIdentity(),
                                scene.box(btVector3(1, 1, 1)), &motion_state);
  body.setAngularVelocity(btVector3(3, 2, 4));
  scene.step(kStep, 10);
  btTransform shown;
  motion_state.getWorldTransform(shown);
  EXPECT_TRUE(shown == body.getWorldTransform());
}

TEST(IntegratedBodies, MayBeRemovedByAnIncidentHandler) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  add_bodies_of_all_kinds(scene);
  btRigidBody& sick = *scene.bodies()[8];
  btRigidBody& neighbour = *scene.bodies()[9];
  scene.world().rotation().set_incident_handler([&](const Incident& incident) {
    scene.world().removeRigidBody(incident.body);
    neighbour.setAngularVelocity(btVector3(0, 0, 7));
  });
  scene.step(kStep, 3);
  sick.setAngularVelocity(btVector3(NAN, 0, 0));
  scene.step(kStep, 3);
  EXPECT_FALSE(sick.isInWorld());
  EXPECT_EQ(scene.world().rotation().incidents(), 1u);
  EXPECT_EQ(scene.world().getNonStaticRigidBodies().size(), static_cast<int>(scene.bodies().size()) - 1);
  // Damped at 0.3 1/s in the two steps since, spinning about a principal axis.
  EXPECT_NEAR(neighbour.getAngularVelocity().z(), 7.0, 0.2);
  scene.world().addRigidBody(&sick);
}

TEST(IntegratedBodies, TakeAnOrientationThatTheApplicationSetsAsItIs) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& body =
      scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0), btQuaternion(3, 1, 4, 2).normalized());
  scene.step(kStep, 2);
  body.getWorldTransform().setRotation(btQuaternion(1, 2, 3, 4).normalized());
  const btMatrix3x3 basis = body.getWorldTransform().getBasis();
  scene.step(kStep);
  Matrix3 expected;
  for (int row = 0; row < 3; ++row) expected.row(row) << basis[row].x(), basis[row].y(), basis[row].z();
  const RotationState state = scene.world().rotation().rotation_of(body).state;
  // measured 0; if taken as a turn on top of the former orientation, it would have Bullet's precision
  EXPECT_LT(state.q_WB.angularDistance(Quaternion(expected).normalized()), 1e-15);
}

TEST(IntegratedBodies, AreInterpolatedEachByItsOwnMeanVelocity) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  for (int i = 1; i <= 20; ++i) {
    scene.add_free(btVector3(1, 2, 3), btVector3(3, static_cast<btScalar>(i) / 4, -4));
  }
  scene.step(kStep);
  for (const auto& body : scene.bodies()) {
    btTransform back;
    btTransformUtil::integrateTransform(body->getInterpolationWorldTransform(), btVector3(0, 0, 0),
                                        body->getInterpolationAngularVelocity(), -kStep, back);
    // The body started at the identity. measured 1.7e-8 (single), 3.5e-17 (double precision)
    for (int row = 0; row < 3; ++row) {
      const btVector3 axis(row == 0, row == 1, row == 2);
      EXPECT_LT((back.getBasis()[row] - axis).length(), by_precision(5e-8, 1e-16));
    }
  }
}

// Bullet then kicks bodies after moving them, and must therefore move them itself.
TEST(IntegratedBodies, AreLeftToBulletUnderSpeculativeRestitution) {
  const auto add_shot = [](auto& scene) {
    scene.world().setApplySpeculativeContactRestitution(true);
    btRigidBody& wall = scene.add_free(btVector3(1, 2, 3), btVector3(1, 2, 3));
    btRigidBody& ball = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 1));
    for (btRigidBody* body : {&wall, &ball}) body->setRestitution(1);
    ball.setCcdMotionThreshold(btScalar(0.01));
    ball.setCcdSweptSphereRadius(btScalar(0.5));
    ball.setLinearVelocity(btVector3(-200, btScalar(0.7), 1));
  };
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  add_shot(subclassed);
  Scene<> attached;
  RotationPlugin plugin(attached.world());
  add_shot(attached);
  for (int step = 1; step <= 60; ++step) {
    subclassed.step(kStep);
    attached.step(kStep);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_TRUE(same_bits(*subclassed.bodies()[i], *attached.bodies()[i]))
          << "body " << i << ", step " << step;
    }
  }
  EXPECT_GT(subclassed.bodies()[1]->getLinearVelocity().x(), btScalar(-190));  // the bodies have collided
}

}  // namespace
}  // namespace polhode::testing
