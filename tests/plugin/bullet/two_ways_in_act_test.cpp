// RotationWorld and RotationPlugin give the same bits from the first step on, whatever acts on the bodies:
// joints, locked axes, contacts, changes between steps and within a step.
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/constrained_scene.h"
#include "support/same_bits.h"
#include "support/same_body_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);

class Kicks final : public btActionInterface {
 public:
  explicit Kicks(btScalar strength) : strength_(strength) {}
  void updateAction(btCollisionWorld* world, btScalar /*dt*/) override {
    ++step_;
    for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
      btRigidBody* body = btRigidBody::upcast(world->getCollisionObjectArray()[i]);
      if (body == nullptr || body->isStaticOrKinematicObject() || (i + step_) % 5 != 0) continue;
      body->setAngularVelocity(body->getAngularVelocity() * (1 - strength_) +
                               btVector3(strength_, 0, strength_));
    }
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

 private:
  btScalar strength_;
  int step_ = 0;
};

/// One body for each kind of constraint, far apart from each other.
template <class AnyScene>
void add_everything(AnyScene& scene) {
  add_hinged_rod(scene, 20);
  add_hinged_rod(scene, 60);
  add_locked(scene, btVector3(1, 1, 0), vector(10, 2, 0));
  add_locked(scene, btVector3(0, 1, 0), vector(0, 2, 0));
  for (int i = 0; i < 6; ++i) scene.add_free(btVector3(1, 2, 3), vector(3, i - 2, 4));
  btRigidBody& a = scene.add_free(btVector3(1, 2, 3), vector(1, 2, 3));
  btRigidBody& b = scene.add_free(btVector3(2, 1, 1), vector(-1, 2, 5));
  scene.template join<btPoint2PointConstraint>(a, b, btVector3(5, 0, 0), btVector3(-5, 0, 0));
  btRigidBody& damped = scene.add_free(btVector3(1, 2, 3), vector(4, 2, 3));
  damped.setDamping(btScalar(0.1), btScalar(0.3));
  // Two bodies that collide, and a box on its own platform.
  btRigidBody& flying = scene.add_free(btVector3(1, 2, 3), vector(1, 2, 3));
  flying.setLinearVelocity(btVector3(8, 0, 0));
  scene.add_free(btVector3(1, 2, 3), vector(3, 2, 1));
  btRigidBody& platform =
      scene.add(0, btVector3(0, 0, 0), btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -30)),
                scene.box(btVector3(5, 5, 1)));
  platform.setFriction(1);
  btRigidBody& resting =
      scene.add_box(vector(0.3, 0.4, 0.5), 1, btTransform(btQuaternion::getIdentity(), vector(0, 0, -28.4)));
  resting.setGravity(btVector3(0, 0, -10));
  resting.setFlags(resting.getFlags() | BT_DISABLE_WORLD_GRAVITY);
  resting.setAngularVelocity(btVector3(1, 2, 6));
}

/// The same scene in a RotationWorld and under a RotationPlugin, which is attached before or after another
/// action is added.
template <class World>
class BothAtOnce {
 public:
  explicit BothAtOnce(bool action_before = false) {
    subclassed.world().addAction(&kicks_here_);
    if (action_before) attached.world().addAction(&kicks_there_);
    plugin_ = std::make_unique<RotationPlugin>(attached.world());
    if (!action_before) attached.world().addAction(&kicks_there_);
    add_everything(subclassed);
    add_everything(attached);
  }
  ~BothAtOnce() {
    subclassed.world().removeAction(&kicks_here_);
    attached.world().removeAction(&kicks_there_);
  }

  RotationControl& rotation_here() { return subclassed.world().rotation(); }
  RotationControl& rotation_there() { return plugin_->rotation(); }

  template <class Function>
  void in_both(Function function) {
    function(subclassed, rotation_here());
    function(attached, rotation_there());
  }

  ::testing::AssertionResult same() {
    for (std::size_t i = 0; i < subclassed.bodies().size(); ++i) {
      const btRigidBody& here = *subclassed.bodies()[i];
      const btRigidBody& there = *attached.bodies()[i];
      if (!same_bits(here, there)) return ::testing::AssertionFailure() << "body " << i;
      if (here.getFlags() != there.getFlags()) return ::testing::AssertionFailure() << "flags of body " << i;
      if (rotation_here().manages(here) != rotation_there().manages(there)) {
        return ::testing::AssertionFailure() << "one of the two manages body " << i;
      }
      if (!rotation_here().manages(here)) continue;
      const BodyRotation a = rotation_here().rotation_of(here);
      const BodyRotation b = rotation_there().rotation_of(there);
      if (!same_bits(a.state, b.state)) return ::testing::AssertionFailure() << "state of body " << i;
      if (a.steps != b.steps) {
        return ::testing::AssertionFailure() << "steps of body " << i << ": " << a.steps << ", " << b.steps;
      }
    }
    return ::testing::AssertionSuccess();
  }

  Scene<RotationWorld<World>> subclassed;
  Scene<World> attached;

 private:
  Kicks kicks_here_{btScalar(0.02)};
  Kicks kicks_there_{btScalar(0.02)};
  std::unique_ptr<RotationPlugin> plugin_;
};

template <class World>
class TwoWaysIn : public ::testing::Test {};
using Worlds = ::testing::Types<btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld,
                                btMultiBodyDynamicsWorld>;
TYPED_TEST_SUITE(TwoWaysIn, Worlds);

TYPED_TEST(TwoWaysIn, AgreeFromTheFirstStepOnForEveryScheme) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    for (const bool action_before : {true, false}) {
      SCOPED_TRACE(std::string(scheme->description().name) +
                   (action_before ? ", action before" : ", action after"));
      BothAtOnce<TypeParam> both(action_before);
      both.in_both([&](auto&, RotationControl& rotation) { rotation.set_default_scheme(scheme); });
      for (int step = 1; step <= 120; ++step) {
        both.in_both([](auto& scene, RotationControl&) { scene.step(kDt); });
        ASSERT_TRUE(both.same()) << "step " << step;
      }
    }
  }
}

// Calls that take no step, one step or several, with time left over.
TYPED_TEST(TwoWaysIn, AgreeWithSubsteps) {
  BothAtOnce<TypeParam> both;
  for (int call = 1; call <= 100; ++call) {
    both.in_both([&](auto& scene, RotationControl&) {
      scene.world().stepSimulation(kDt * static_cast<btScalar>(call % 5) / 2, 4, kDt);
    });
    ASSERT_TRUE(both.same()) << "call " << call;
  }
}

// Applies one change to a body between two steps.
void change(btRigidBody& body, int what) {
  switch (what) {
    case 0:
      body.applyTorqueImpulse(btVector3(1, 2, btScalar(0.3)));
      break;
    case 1:
      body.setCenterOfMassTransform(
          btTransform(btQuaternion(1, 2, 3, 4).normalized(), body.getWorldTransform().getOrigin()));
      break;
    case 2:
      body.getWorldTransform().setRotation(btQuaternion(4, 1, 2, 3).normalized());
      break;
    case 3:
      body.setInvInertiaDiagLocal(btVector3(1, btScalar(0.5), btScalar(0.25)));
      body.updateInertiaTensor();
      break;
    case 4:
      body.setFlags(body.getFlags() ^ BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);
      break;
    case 5:
      body.applyTorque(btVector3(10, -20, 5));
      break;
    case 6:
      body.setAngularFactor(btVector3(1, 0, 1));
      break;
    case 7:
      body.setAngularFactor(btVector3(1, 1, 1));
      break;
    case 8:
      body.setAngularVelocity(btVector3(0, 0, 0));
      break;
    case 9:
      body.setDamping(0, btScalar(0.2));
      break;
    case 10:
      body.setInvInertiaDiagLocal(btVector3(0, 1, 1));
      body.updateInertiaTensor();
      break;
    default:
      break;
  }
}

TYPED_TEST(TwoWaysIn, AgreeWithChangesBetweenSteps) {
  BothAtOnce<TypeParam> both;
  for (int step = 1; step <= 300; ++step) {
    both.in_both([&](auto& scene, RotationControl& rotation) {
      for (std::size_t i = 0; i < scene.bodies().size(); ++i) {
        btRigidBody& body = *scene.bodies()[i];
        if (body.isStaticOrKinematicObject()) continue;
        change(body, (static_cast<int>(i) * 5 + step * 7) % 61);
        if ((static_cast<int>(i) + step) % 97 == 0) rotation.release(body);
        if ((static_cast<int>(i) + step) % 97 == 20) rotation.set_scheme(body, "implicit_midpoint");
        if ((static_cast<int>(i) + step) % 97 == 60) rotation.use_default_scheme(body);
      }
      scene.step(kDt);
    });
    ASSERT_TRUE(both.same()) << "step " << step;
  }
}

// Tick callbacks at the start and end of a step make the changes.
TYPED_TEST(TwoWaysIn, AgreeWithChangesWithinAStep) {
  for (const bool pre : {true, false}) {
    BothAtOnce<TypeParam> both;
    const auto kick_all = [](btDynamicsWorld* world, btScalar) {
      for (int i = 0; i < world->getNumCollisionObjects(); i += 3) {
        btRigidBody* body = btRigidBody::upcast(world->getCollisionObjectArray()[i]);
        if (!body->isStaticOrKinematicObject())
          body->applyTorqueImpulse(btVector3(btScalar(0.1), 0, btScalar(0.2)));
      }
    };
    both.in_both([&](auto& scene, RotationControl&) {
      scene.world().setInternalTickCallback(kick_all, nullptr, pre);
    });
    for (int step = 1; step <= 120; ++step) {
      both.in_both([](auto& scene, RotationControl&) { scene.step(kDt); });
      ASSERT_TRUE(both.same()) << "step " << step << (pre ? ", before" : ", after");
    }
  }
}

TYPED_TEST(TwoWaysIn, AgreeWhenBodiesComeAndGo) {
  BothAtOnce<TypeParam> both;
  for (int step = 1; step <= 120; ++step) {
    both.in_both([&](auto& scene, RotationControl&) {
      if (step % 7 == 3) scene.add_free(btVector3(1, 2, 3), vector(1, step % 5, 2));
      if (step % 11 == 5) scene.remove(*scene.bodies().back());
      btRigidBody& again = *scene.bodies()[6];
      if (step % 13 == 6) scene.world().removeRigidBody(&again);
      if (step % 13 == 9) scene.world().addRigidBody(&again);
      if (step % 17 == 2) scene.bodies()[7]->forceActivationState(ISLAND_SLEEPING);
      if (step % 17 == 9) scene.bodies()[7]->forceActivationState(DISABLE_DEACTIVATION);
      scene.step(kDt);
    });
    ASSERT_TRUE(both.same()) << "step " << step;
  }
}

// For solvers that assume a symmetric matrix, both must provide one.
TEST(TwoWaysInOfADantzigSolver, Agree) {
  btDantzigSolver inner_here, inner_there;
  btMLCPSolver here(&inner_here), there(&inner_there);
  BothAtOnce<btDiscreteDynamicsWorld> both;
  both.subclassed.world().setConstraintSolver(&here);
  both.attached.world().setConstraintSolver(&there);
  for (int step = 1; step <= 120; ++step) {
    both.in_both([](auto& scene, RotationControl&) { scene.step(kDt); });
    ASSERT_TRUE(both.same()) << "step " << step;
  }
}

}  // namespace
}  // namespace polhode::testing
