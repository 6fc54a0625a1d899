// Bodies are stepped in batches of eight. Each must get the same bits as in a world of its own, whatever
// happens to the body or to its neighbours.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "polhode/scheme_registry.h"
#include "support/both_ways.h"
#include "support/same_bits.h"
#include "support/same_body_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);
constexpr int kBodies = 45;  // five batches of eight, and five more
constexpr int kSteps = 40;

btScalar fraction(int body, int of) {
  return static_cast<btScalar>(body % of) / static_cast<btScalar>(of);
}

template <class Way>
btRigidBody& add_body(Way& way, int body) {
  btRigidBody& added =
      way.add_free(btVector3(1 + fraction(body, 7), 2 - fraction(body, 5), 3),
                   btVector3(3 - 6 * fraction(body, 4), 2 + fraction(body, 11), 4 * fraction(body, 3)),
                   btQuaternion(btVector3(1, fraction(body, 13), 2).normalized(), 3 * fraction(body, 17)));
  added.setUserIndex(body);
  added.getWorldTransform().setOrigin(btVector3(10 * static_cast<btScalar>(body), 0, 0));
  added.setLinearVelocity(btVector3(fraction(body, 3), -1, fraction(body, 2)));
  return added;
}

// Otherwise no body would move freely after a while.
void make_usual_again(btRigidBody& body) {
  body.setDamping(0, 0);
  body.setAngularFactor(btVector3(1, 1, 1));
  body.setInvInertiaDiagLocal(btVector3(1, btScalar(0.5), btScalar(0.25)));
  body.updateInertiaTensor();
  body.setCcdMotionThreshold(0);
  body.forceActivationState(ACTIVE_TAG);
}

void apply_torque_B(btRigidBody& body, const btVector3& torque_B) {
  body.applyTorque(body.getWorldTransform().getBasis() * torque_B);
}

// Changes some of the bodies before some of the steps, as an application does.
void act_on(btRigidBody& body, int number, int step) {
  if ((number + step) % 20 == 0) make_usual_again(body);
  // Changes all bodies in the same step.
  if (step % 40 == 13) body.getWorldTransform().setRotation(btQuaternion(4, 1, 2, 3).normalized());
  switch ((number * 5 + step * 7) % 211) {
    case 1:
      body.applyTorqueImpulse(btVector3(1, 2, btScalar(0.3)));
      break;
    case 2:
      body.getWorldTransform().setRotation(btQuaternion(1, 2, 3, 4).normalized());
      break;
    case 3:
    case 3 + 2 * 7:  // two steps after the first torque
      apply_torque_B(body, btVector3(10, -20, 5));
      break;
    case 4:
      body.setDamping(btScalar(0.1), btScalar(0.2));
      break;
    case 5:
      body.setAngularFactor(btVector3(1, 0, 1));
      break;
    case 6:
      body.setFlags(body.getFlags() | BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
      break;
    case 7:
      body.setInvInertiaDiagLocal(btVector3(1, btScalar(0.5), btScalar(0.25)));
      body.updateInertiaTensor();
      break;
    case 8:
      body.applyCentralForce(btVector3(0, 0, 30));
      break;
    case 9:
      body.setCenterOfMassTransform(btTransform(btQuaternion(4, 3, 2, 1).normalized(),
                                                body.getWorldTransform().getOrigin() + btVector3(0, 1, 2)));
      break;
    case 10:
      body.setAngularVelocity(btVector3(NAN, 0, 0));
      break;
    case 11:
      body.forceActivationState(ISLAND_SLEEPING);
      break;
    case 12:
      body.forceActivationState(DISABLE_DEACTIVATION);
      break;
    case 13:
      body.setInvInertiaDiagLocal(btVector3(0, 1, 1));
      body.updateInertiaTensor();
      break;
    case 14:
      body.setCcdMotionThreshold(btScalar(0.01));
      body.setCcdSweptSphereRadius(btScalar(0.1));
      break;
    case 15:
      body.getWorldTransform().setOrigin(btVector3(NAN, 1, 2));
      break;
    case 16:
      body.setLinearVelocity(btVector3(0, NAN, 0));
      break;
    case 19:
      body.setHitFraction(btScalar(0.5));
      break;
    default:
      break;
  }
}

// Compares every bit that a step writes to a body.
::testing::AssertionResult are_same(btRigidBody& a, btRigidBody& b) {
  if (!same_bits(a, b)) return ::testing::AssertionFailure() << "pose or velocity";
  const auto same = [](const btVector3& u, const btVector3& v) {
    return u.x() == v.x() && u.y() == v.y() && u.z() == v.z();
  };
  for (int row = 0; row < 3; ++row) {
    if (!same(a.getInvInertiaTensorWorld()[row], b.getInvInertiaTensorWorld()[row])) {
      return ::testing::AssertionFailure() << "inertia tensor";
    }
    if (!same(a.getInterpolationWorldTransform().getBasis()[row],
              b.getInterpolationWorldTransform().getBasis()[row])) {
      return ::testing::AssertionFailure() << "interpolated basis";
    }
  }
  if (!same(a.getInterpolationWorldTransform().getOrigin(), b.getInterpolationWorldTransform().getOrigin())) {
    return ::testing::AssertionFailure() << "interpolated position";
  }
  if (!same(a.getInterpolationLinearVelocity(), b.getInterpolationLinearVelocity()) ||
      !same(a.getInterpolationAngularVelocity(), b.getInterpolationAngularVelocity())) {
    return ::testing::AssertionFailure() << "interpolated velocity";
  }
  // The broadphase box depends on the pose predicted in the step.
  if (!same(a.getBroadphaseHandle()->m_aabbMin, b.getBroadphaseHandle()->m_aabbMin) ||
      !same(a.getBroadphaseHandle()->m_aabbMax, b.getBroadphaseHandle()->m_aabbMax)) {
    return ::testing::AssertionFailure() << "bounding box";
  }
  if (a.getHitFraction() != b.getHitFraction()) return ::testing::AssertionFailure() << "hit fraction";
  if (a.getFlags() != b.getFlags()) return ::testing::AssertionFailure() << "flags";
  return ::testing::AssertionSuccess();
}

/// Kicks some bodies after Bullet has moved them.
class LateKicks final : public btActionInterface {
 public:
  void updateAction(btCollisionWorld* world, btScalar /*dt*/) override {
    ++step_;
    for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
      btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
      if ((body.getUserIndex() + step_) % 11 != 0) continue;
      body.setAngularVelocity(body.getAngularVelocity() + btVector3(1, btScalar(0.5), 0));
    }
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

 private:
  int step_ = 0;
};

/// Another action of the application runs before the plugin.
class UnderRotationPluginAfterAnAction : public Scene<btDiscreteDynamicsWorld> {
 public:
  static constexpr const char* kName = "UnderRotationPluginAfterAnAction";

  UnderRotationPluginAfterAnAction() {
    world().addAction(&kicks_);
    plugin_ = std::make_unique<RotationPlugin>(world());
  }
  ~UnderRotationPluginAfterAnAction() { world().removeAction(&kicks_); }
  UnderRotationPluginAfterAnAction(const UnderRotationPluginAfterAnAction&) = delete;
  UnderRotationPluginAfterAnAction& operator=(const UnderRotationPluginAfterAnAction&) = delete;

  RotationControl& rotation() { return plugin_->rotation(); }

 private:
  LateKicks kicks_;
  std::unique_ptr<RotationPlugin> plugin_;
};

using Ways = ::testing::Types<InRotationWorld, UnderRotationPlugin, UnderRotationPluginAfterAnAction>;

template <class Way>
class UntouchedBodies : public ::testing::Test {
 protected:
  // Bodies that never touch and share only their batch.
  void start(const std::string& scheme) {
    together_ = std::make_unique<Way>();
    together_->rotation().set_default_scheme(scheme);
    alone_.clear();
    for (int i = 0; i < kBodies; ++i) {
      add_body(*together_, i);
      alone_.push_back(std::make_unique<Way>());
      alone_.back()->rotation().set_default_scheme(scheme);
      add_body(*alone_.back(), i);
    }
  }

  btRigidBody& body(int i) { return *together_->bodies()[static_cast<std::size_t>(i)]; }
  Way& alone(int i) { return *alone_[static_cast<std::size_t>(i)]; }
  btRigidBody& body_alone(int i) { return *alone(i).bodies()[0]; }

  void step() {
    together_->step(kStep);
    for (auto& way : alone_) way->step(kStep);
  }

  void expect_as_alone(const std::string& when) {
    for (int i = 0; i < kBodies; ++i) {
      ASSERT_TRUE(are_same(body(i), body_alone(i))) << "body " << i << ", " << when;
      if (!alone(i).rotation().manages(body_alone(i))) continue;
      const BodyRotation here = together_->rotation().rotation_of(body(i));
      const BodyRotation there = alone(i).rotation().rotation_of(body_alone(i));
      ASSERT_TRUE(same_bits(here.state, there.state)) << "body " << i << ", " << when;
      ASSERT_EQ(here.steps, there.steps);
      ASSERT_EQ(here.diverged, there.diverged);
    }
  }

  std::unique_ptr<Way> together_;
  std::vector<std::unique_ptr<Way>> alone_;
};

TYPED_TEST_SUITE(UntouchedBodies, Ways, WayName);

TYPED_TEST(UntouchedBodies, GetTheSameBitsAsEachAlone) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    const std::string name(scheme->description().name);
    this->start(name);
    for (int step = 1; step <= kSteps; ++step) {
      this->step();
      this->expect_as_alone(name + ", step " + std::to_string(step));
    }
  }
}

TYPED_TEST(UntouchedBodies, GetTheSameBitsAsEachAloneWhateverTheApplicationDoes) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    const std::string name(scheme->description().name);
    this->start(name);
    for (int step = 1; step <= 2 * kSteps; ++step) {
      for (int i = 0; i < kBodies; ++i) {
        act_on(this->body(i), i, step);
        act_on(this->body_alone(i), i, step);
      }
      this->step();
      this->expect_as_alone(name + ", step " + std::to_string(step));
    }
  }
}

// One body of a batch diverges; the other seven continue.
TYPED_TEST(UntouchedBodies, GoOnWhenOneOfThemDiverges) {
  for (const char* name : {"semi_implicit_gyroscopic", "matrix"}) {
    this->start(name);
    for (btRigidBody* fast : {&this->body(3), &this->body_alone(3)}) {
      fast->setAngularVelocity(btVector3(300, 40, -500));
    }
    for (int step = 1; step <= kSteps; ++step) {
      this->step();
      this->expect_as_alone(std::string(name) + ", step " + std::to_string(step));
    }
    EXPECT_TRUE(this->together_->rotation().rotation_of(this->body(3)).diverged);
    EXPECT_FALSE(this->together_->rotation().rotation_of(this->body(4)).diverged);
  }
}

}  // namespace
}  // namespace polhode::testing
