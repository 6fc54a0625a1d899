// Worlds in which Bullet's collision detection caches every kind of data: each continues with the same bits
// after restoring.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <LinearMath/btSerializer.h>
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/multibody_scene.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);

template <class Way>
class SnapshotOfKinds : public ::testing::Test {
 protected:
  // Also restores into a twin, which has none of the contacts.
  template <class Build>
  void expect_same_bits(const Build& build, const std::vector<int>& moments, int steps = 200) {
    Way way;
    build(way);
    int now = 0;
    for (const int moment : moments) {
      way.step(kStep, moment - now);
      const Snapshot snapshot = way.rotation().save_world();
      const auto went_on = run(way, steps, kStep);
      EXPECT_GT(way.world().getDispatcher()->getNumManifolds(), 0);
      way.rotation().restore_world(snapshot);
      EXPECT_TRUE(way.rotation().save_world() == snapshot);
      EXPECT_EQ(first_difference(went_on, run(way, steps, kStep)), 0) << "saved at step " << moment;
      Way twin;
      build(twin);
      twin.rotation().restore_world(snapshot);
      EXPECT_EQ(first_difference(went_on, run(twin, steps, kStep)), 0)
          << "into a twin, saved at step " << moment;
      way.rotation().restore_world(snapshot);
      now = moment;
    }
  }
};
TYPED_TEST_SUITE(SnapshotOfKinds, BothWays, WayName);

template <class Way>
btRigidBody& drop(Way& way, btCollisionShape& shape, int i) {
  btVector3 inertia_B;
  shape.calculateLocalInertia(1, inertia_B);
  const btTransform pose(btQuaternion(1, 2, btScalar(i), 4).normalized(),
                         vector(0.3 * (i % 3), 0.2 * (i % 4), 0.7 + 0.8 * i));
  btRigidBody& body = way.add(1, inertia_B, pose, shape);
  body.setAngularVelocity(vector(1, -2, 0.5 * i));
  body.forceActivationState(ACTIVE_TAG);
  return body;
}

template <class Way>
void drop_convex_shapes(Way& way) {
  set_gravity(way);
  auto& hull = way.template shape<btConvexHullShape>();
  for (int corner = 0; corner < 8; ++corner)
    hull.addPoint(vector(corner & 1 ? 0.3 : -0.3, corner & 2 ? 0.4 : -0.2, corner & 4 ? 0.2 : -0.3));
  btCollisionShape* const shapes[] = {&hull,
                                      &way.template shape<btSphereShape>(btScalar(0.3)),
                                      &way.template shape<btCapsuleShape>(btScalar(0.2), btScalar(0.4)),
                                      &way.template shape<btCylinderShape>(vector(0.3, 0.2, 0.3)),
                                      &way.template shape<btConeShape>(btScalar(0.3), btScalar(0.5)),
                                      &way.box(vector(0.3, 0.2, 0.4))};
  for (int i = 0; i < 18; ++i) drop(way, *shapes[i % 6], i);
}

TYPED_TEST(SnapshotOfKinds, ConvexShapesOnAPlane) {
  this->expect_same_bits(
      [](auto& way) {
        way.add(0, btVector3(0, 0, 0), btTransform::getIdentity(),
                way.template shape<btStaticPlaneShape>(vector(0, 0, 1), btScalar(0)));
        drop_convex_shapes(way);
      },
      {30, 100, 400});
}

TYPED_TEST(SnapshotOfKinds, ConvexShapesOnATriangleMesh) {
  btTriangleMesh mesh;
  const auto corner = [](int x, int y) { return vector(x, y, 0.2 * ((x * 7 + y * 3) % 5)); };
  for (int x = -5; x < 5; ++x) {
    for (int y = -5; y < 5; ++y) {
      mesh.addTriangle(corner(x, y), corner(x + 1, y), corner(x, y + 1));
      mesh.addTriangle(corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1));
    }
  }
  this->expect_same_bits(
      [&mesh](auto& way) {
        way.add(0, btVector3(0, 0, 0), btTransform::getIdentity(),
                way.template shape<btBvhTriangleMeshShape>(&mesh, true));
        drop_convex_shapes(way);
      },
      {30, 100, 400});
}

// Dumbbells and crosses: a pair has one manifold for each pair of close parts.
template <class Way>
void drop_compounds(Way& way, bool has_tree) {
  set_gravity(way);
  for (int i = 0; i < 8; ++i) {
    auto& compound = way.template shape<btCompoundShape>(has_tree);
    for (int part = 0; part < 3; ++part) {
      const btTransform pose(btQuaternion::getIdentity(),
                             vector(0.6 * (part - 1), 0.1 * part, 0.2 * (part % 2)));
      compound.addChildShape(pose, &way.box(vector(0.25, 0.3, 0.2)));
    }
    drop(way, compound, 2 * i);
    drop(way, way.template shape<btSphereShape>(btScalar(0.3)), 2 * i + 1);
  }
}

TYPED_TEST(SnapshotOfKinds, CompoundsOnAFloor) {
  for (const bool has_tree : {true, false}) {
    SCOPED_TRACE(has_tree);
    this->expect_same_bits(
        [has_tree](auto& way) {
          way.add_floor();
          drop_compounds(way, has_tree);
        },
        {30, 100, 400});
  }
}

TYPED_TEST(SnapshotOfKinds, GhostsAndKinematicBodies) {
  btGhostObject ghost;
  btGhostObject twins_ghost;
  btBoxShape room(btVector3(2, 2, 2));
  ghost.setCollisionShape(&room);
  ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
  TypeParam way;
  way.world().addCollisionObject(&ghost);
  way.add_floor();
  btRigidBody& lift =
      way.add_kinematic(btTransform(btQuaternion::getIdentity(), vector(0, 0, 0.2)), 1, btVector3(1, 1, 1));
  drop_convex_shapes(way);
  const auto play = [&](int steps) {
    std::vector<std::uint64_t> digests;
    for (int i = 0; i < steps; ++i) {
      btTransform pose = lift.getWorldTransform();
      pose.getOrigin() += vector(0, 0.001, 0.002);
      lift.setWorldTransform(pose);
      way.step(kStep);
      digests.push_back(digest_of(way.world(), way.rotation()));
    }
    return digests;
  };
  play(100);
  const Snapshot snapshot = way.rotation().save_world();
  const auto went_on = play(200);
  way.rotation().restore_world(snapshot);
  EXPECT_EQ(first_difference(went_on, play(200)), 0);
  way.world().removeCollisionObject(&ghost);
}

TYPED_TEST(SnapshotOfKinds, BodiesThatContinuousCollisionDetectionStops) {
  this->expect_same_bits(
      [](auto& way) {
        way.add_floor();
        drop_convex_shapes(way);
        for (const auto& body : way.bodies()) {
          if (body->isStaticObject()) continue;
          body->setCcdMotionThreshold(btScalar(0.1));
          body->setCcdSweptSphereRadius(btScalar(0.15));
          body->setLinearVelocity(vector(0, 0, -30));
        }
      },
      {1, 3, 30});
}

TYPED_TEST(SnapshotOfKinds, BodiesThatBulletRotates) {
  this->expect_same_bits(
      [](auto& way) {
        way.rotation().clear_default_scheme();
        way.add_floor();
        drop_convex_shapes(way);
        way.rotation().set_scheme(*way.bodies()[3], "exact");
      },
      {1, 100});
}

// The snapshot includes the time left over between fixed steps.
TYPED_TEST(SnapshotOfKinds, Substeps) {
  TypeParam way;
  way.add_floor();
  drop_convex_shapes(way);
  const auto play = [&way] {
    std::vector<std::uint64_t> digests;
    for (int i = 0; i < 97; ++i) {
      way.world().stepSimulation(btScalar(0.011), 4, btScalar(1.0 / 120.0));
      digests.push_back(digest_of(way.world(), way.rotation()));
    }
    return digests;
  };
  play();
  const Snapshot snapshot = way.rotation().save_world();
  const auto went_on = play();
  way.rotation().restore_world(snapshot);
  EXPECT_EQ(first_difference(went_on, play()), 0);
}

TYPED_TEST(SnapshotOfKinds, ASolverThatDrawsItsOrder) {
  this->expect_same_bits(
      [](auto& way) {
        way.world().getSolverInfo().m_solverMode |= SOLVER_RANDMIZE_ORDER;
        way.add_floor();
        drop_convex_shapes(way);
        add_chain(way, 4);
      },
      {50, 200});
}

TYPED_TEST(SnapshotOfKinds, JointsThatBreakAndCount) {
  TypeParam way;
  btRigidBody& wheel = way.add_free(btVector3(1, 2, 3), btVector3(0, 0, 9));
  auto& hinge =
      way.template join<btHingeAccumulatedAngleConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 0, 1));
  btRigidBody& hung = way.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
  auto& thread = way.template join<btPoint2PointConstraint>(hung, btVector3(0, 0, 1));
  thread.setBreakingImpulseThreshold(btScalar(0.5));
  for (int i = 0; i < 30; ++i) {
    way.step(kStep);
    hinge.getAccumulatedHingeAngle();
  }
  const btScalar turned = hinge.getAccumulatedHingeAngle();
  EXPECT_GT(btFabs(turned), btScalar(4));
  const Snapshot snapshot = way.rotation().save_world();
  hung.applyCentralImpulse(btVector3(0, 0, 100));
  way.step(kStep, 5);
  EXPECT_FALSE(thread.isEnabled());
  hinge.setAccumulatedHingeAngle(0);
  way.rotation().restore_world(snapshot);
  EXPECT_TRUE(thread.isEnabled());
  EXPECT_EQ(hinge.getAccumulatedHingeAngle(), turned);
}

// The snapshot and Bullet's serializer do not affect each other.
TYPED_TEST(SnapshotOfKinds, BesideBulletsSerializer) {
  TypeParam way;
  way.add_floor();
  drop_convex_shapes(way);
  way.step(kStep, 100);
  const Snapshot snapshot = way.rotation().save_world();
  const auto went_on = run(way, 50, kStep);
  way.rotation().restore_world(snapshot);
  btDefaultSerializer serializer;
  way.world().serialize(&serializer);
  EXPECT_GT(serializer.getCurrentBufferSize(), 0);
  EXPECT_TRUE(way.rotation().save_world() == snapshot);
  EXPECT_EQ(first_difference(went_on, run(way, 50, kStep)), 0);
}

int added_points = 0;
int destroyed_points = 0;
bool count_added(btManifoldPoint& point, const btCollisionObjectWrapper* /*a*/, int /*part_a*/,
                 int /*index_a*/, const btCollisionObjectWrapper* /*b*/, int /*part_b*/, int /*index_b*/) {
  ++added_points;
  point.m_userPersistentData = &added_points;
  return false;
}
bool count_destroyed(void* /*data*/) {
  ++destroyed_points;
  return true;
}

// Applications free the data that they attach to contact points in Bullet's callback.
TYPED_TEST(SnapshotOfKinds, RestoringCallsNoContactCallbackButGivesUserDataBack) {
  TypeParam way;
  way.add_floor();
  drop_convex_shapes(way);
  for (const auto& body : way.bodies())
    body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  way.step(kStep, 100);
  const Snapshot snapshot = way.rotation().save_world();
  gContactAddedCallback = count_added;
  gContactDestroyedCallback = count_destroyed;
  way.step(kStep, 100);
  const int added = added_points;
  EXPECT_GT(added, 0);
  way.rotation().restore_world(snapshot);
  EXPECT_EQ(added_points, added);
  EXPECT_EQ(gContactAddedCallback, &count_added);
  EXPECT_GT(destroyed_points, 0);
  gContactAddedCallback = nullptr;
  gContactDestroyedCallback = nullptr;
}

TEST(SnapshotOfAWorld, WithMultibodiesIsRefused) {
  MultibodyScene<btMultiBodyDynamicsWorld> scene;
  RotationPlugin plugin(scene.world());
  EXPECT_NO_THROW(plugin.rotation().save_world());
  scene.add_free_multibody(btVector3(1, 2, 3), btVector3(1, 1, 1));
  EXPECT_THROW(plugin.rotation().save_world(), std::invalid_argument);
}

TEST(SnapshotOfAWorld, WithAnotherBroadphaseIsRefused) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btAxisSweep3 broadphase(btVector3(-10, -10, -10), btVector3(10, 10, 10));
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  const RotationPlugin plugin(world);
  EXPECT_THROW(plugin.rotation().save_world(), std::invalid_argument);
}

TEST(SnapshotOfAWorld, UnderADetachedPluginIsRefused) {
  UnderRotationPlugin way;
  btRigidBody& body = way.add_free(btVector3(1, 2, 3), btVector3(1, 1, 1));
  const Snapshot of_body = way.rotation().save(body);
  const Snapshot of_world = way.rotation().save_world();
  way.plugin().detach();
  EXPECT_THROW(way.rotation().save_world(), std::logic_error);
  EXPECT_THROW(way.rotation().restore_world(of_world), std::logic_error);
  EXPECT_THROW(way.rotation().restore(body, of_body), std::logic_error);
  way.plugin().attach();
  way.rotation().restore_world(of_world);
  way.rotation().restore(body, of_body);
}

TEST(SnapshotOfAWorld, ThatIsEmptyIsRestored) {
  InRotationWorld way;
  const Snapshot snapshot = way.rotation().save_world();
  way.step(kStep);
  way.rotation().restore_world(snapshot);
  EXPECT_EQ(way.rotation().save_world(), snapshot);
}

TEST(SnapshotOfAWorld, OfAMultithreadedWorldGoesOnWithTheSameBits) {
  Scene<RotationWorld<btDiscreteDynamicsWorldMt>> scene;
  scene.add_floor();
  set_gravity(scene);
  for (int i = 0; i < 12; ++i) drop(scene, scene.box(vector(0.3, 0.2, 0.4)), i);
  RotationControl& rotation = scene.world().rotation();
  const auto play = [&] {
    scene.step(kStep, 200);
    return digest_of(scene.world(), rotation);
  };
  play();
  const Snapshot snapshot = rotation.save_world();
  const std::uint64_t went_on = play();
  rotation.restore_world(snapshot);
  EXPECT_EQ(play(), went_on);
}

}  // namespace
}  // namespace polhode::testing
