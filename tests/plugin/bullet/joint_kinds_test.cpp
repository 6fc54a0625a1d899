// Every kind of joint in Bullet, and other constraints: no joint comes apart, and none gains energy.
#include <gtest/gtest.h>

#include <functional>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);

template <class Way>
class JointKinds : public ::testing::Test {
 protected:
  // Adds two bodies, half a metre above each other, that turn and tumble together.
  void add_pair() {
    a_ = &add(vector(0, 0, 0));
    b_ = &add(vector(0, 0, 1));
  }

  // A gap in m. measured 7.0e-3, plain Bullet 5.3e-3
  static constexpr double kGap = 0.01;

  // Runs for ten seconds; checks `off` after the first second.
  void expect_held(const std::function<double()>& off, double bound) {
    const double start = energy_of(*a_) + energy_of(*b_);
    Range error, energy;
    for (int i = 0; i < 600; ++i) {
      scene_.step(kDt);
      energy.add((energy_of(*a_) + energy_of(*b_)) / start);
      if (i >= 60) error.add(off());
    }
    EXPECT_LT(error.highest, bound);
    EXPECT_LT(energy.highest, 1.0001);  // measured 1.00003
  }

  Vector3 gap_between(const btVector3& in_a, const btVector3& in_b) const {
    return to_double(a_->getWorldTransform() * in_a - b_->getWorldTransform() * in_b);
  }

  Way scene_;
  btRigidBody* a_ = nullptr;
  btRigidBody* b_ = nullptr;

 private:
  btRigidBody& add(const btVector3& origin) {
    btRigidBody& body =
        scene_.add(1, vector(0.1, 0.2, 0.25), btTransform(btQuaternion::getIdentity(), origin),
                   scene_.box(vector(0.1, 0.1, 0.1)));
    const btVector3 omega_W = vector(1, 0.5, 10);
    body.setAngularVelocity(omega_W);
    body.setLinearVelocity(omega_W.cross(origin - vector(0, 0, 0.5)));
    return body;
  }
};
TYPED_TEST_SUITE(JointKinds, BothWays, WayName);

const btVector3 kUp(0, 0, btScalar(0.5));

btTransform at(const btVector3& origin) {
  return btTransform(btQuaternion::getIdentity(), origin);
}

TYPED_TEST(JointKinds, Point) {
  this->add_pair();
  this->scene_.template join<btPoint2PointConstraint>(*this->a_, *this->b_, kUp, -kUp);
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

TYPED_TEST(JointKinds, ConeTwist) {
  this->add_pair();
  auto& joint = this->scene_.template join<btConeTwistConstraint>(*this->a_, *this->b_, at(kUp), at(-kUp));
  joint.setLimit(btScalar(0.3), btScalar(0.3), btScalar(0.3));
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

TYPED_TEST(JointKinds, Slider) {
  this->add_pair();
  auto& joint = this->scene_.template join<btSliderConstraint>(*this->a_, *this->b_, at(kUp), at(-kUp), true);
  joint.setLowerLinLimit(0);
  joint.setUpperLinLimit(0);
  this->expect_held([&] { return angle_between(basis_of(*this->a_), basis_of(*this->b_)); },
                    by_precision(2e-7, 3e-15));  // measured 6.4e-8 in single, 7.2e-16 in double precision
}

TYPED_TEST(JointKinds, SixDegrees) {
  this->add_pair();
  auto& joint =
      this->scene_.template join<btGeneric6DofConstraint>(*this->a_, *this->b_, at(kUp), at(-kUp), true);
  joint.setAngularLowerLimit(vector(-0.3, 0, 0));
  joint.setAngularUpperLimit(vector(0.3, 0, 0));
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

TYPED_TEST(JointKinds, SixDegreesWithLimits) {
  this->add_pair();
  auto& joint =
      this->scene_.template join<btGeneric6DofSpring2Constraint>(*this->a_, *this->b_, at(kUp), at(-kUp));
  joint.setLinearLowerLimit(btVector3(0, 0, 0));
  joint.setLinearUpperLimit(btVector3(0, 0, 0));
  joint.setAngularLowerLimit(vector(-0.3, -0.3, 0));
  joint.setAngularUpperLimit(vector(0.3, 0.3, 0));
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

TYPED_TEST(JointKinds, Universal) {
  this->add_pair();
  this->scene_.template join<btUniversalConstraint>(*this->a_, *this->b_, kUp, btVector3(0, 1, 0),
                                                    btVector3(1, 0, 0));
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

// A hinge at its limit.
TYPED_TEST(JointKinds, HingeWithLimits) {
  this->add_pair();
  auto& hinge = this->scene_.template join<btHingeConstraint>(*this->a_, *this->b_, kUp, -kUp,
                                                              btVector3(1, 0, 0), btVector3(1, 0, 0));
  hinge.setLimit(btScalar(-0.2), btScalar(0.2));
  this->expect_held([&] { return this->gap_between(kUp, -kUp).norm(); }, this->kGap);
}

// Two joints on one body: a rod held at both ends is on a hinge.
TYPED_TEST(JointKinds, TwoPointsMakeAHinge) {
  btRigidBody& rod = this->scene_.add_free(vector(1, 0.1, 1), vector(0, 0, 20),
                                           btQuaternion(btVector3(1, 0, 0), btScalar(0.4)));
  const btMatrix3x3 to_B = rod.getWorldTransform().getBasis().transpose();
  for (const btVector3& end : {kUp, -kUp})
    this->scene_.template join<btPoint2PointConstraint>(rod, to_B * end);
  this->scene_.world().getSolverInfo().m_numIterations = 50;
  const Vector3 axis_B = to_double(to_B * btVector3(0, 0, 1));
  const double start = energy_of(rod);
  Range axis_off, energy;
  for (int i = 0; i < 600; ++i) {
    this->scene_.step(kDt);
    axis_off.add(angle_between_axes(basis_of(rod) * axis_B, Vector3::UnitZ()));
    energy.add(energy_of(rod) / start);
  }
  // measured 4.8e-8 in single, 1.2e-12 in double precision; plain Bullet 2.3e-7, 4.6e-13
  EXPECT_LT(axis_off.highest, by_precision(2e-7, 4e-12));
  // measured 1.0044; plain Bullet ends at 0.058
  EXPECT_NEAR(energy.highest, 1, 0.01);
  EXPECT_NEAR(energy.last, 1, 0.01);
}

// Two gear wheels, each on a hinge: the ratio determines the speed of the second.
TYPED_TEST(JointKinds, Gear) {
  btRigidBody* wheels[2];
  for (btRigidBody*& wheel : wheels) {
    wheel = &this->scene_.add_free(btVector3(1, 1, 2), btVector3(0, 0, 0));
    this->scene_.template join<btHingeConstraint>(*wheel, btVector3(0, 0, 0), btVector3(0, 0, 1));
  }
  wheels[0]->setAngularVelocity(btVector3(0, 0, 20));
  this->scene_.template join<btGearConstraint>(*wheels[0], *wheels[1], btVector3(0, 0, 1), btVector3(0, 0, 1),
                                               2);
  this->scene_.step(kDt, 300);
  EXPECT_GT(std::abs(omega_of(*wheels[0]).z()), 15);                           // measured 16
  EXPECT_NEAR(omega_of(*wheels[0]).z() / omega_of(*wheels[1]).z(), -2, 1e-6);  // measured -2 to the bit
}

// The application turns the partner, which turns the rod.
TYPED_TEST(JointKinds, WeldToAKinematicBody) {
  auto& scene = this->scene_;
  btRigidBody& turntable = scene.add_kinematic(btTransform::getIdentity(), 0, btVector3(0, 0, 0));
  btRigidBody& rod =
      scene.add(1, vector(1, 0.1, 1), btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.6))),
                scene.box(vector(0.1, 0.1, 0.1)));
  scene.template join<btFixedConstraint>(turntable, rod, btTransform::getIdentity(),
                                         rod.getWorldTransform().inverse());
  Range off;
  const Matrix3 mounted = basis_of(rod);
  for (int i = 1; i <= 600; ++i) {
    const btQuaternion turned(btVector3(0, 0, 1), btScalar(i * 0.1));
    turntable.setWorldTransform(btTransform(turned));
    scene.step(kDt);
    if (i > 60) off.add(angle_between(basis_of(rod), Matrix3(to_double(btMatrix3x3(turned)) * mounted)));
  }
  EXPECT_LT(off.highest, 0.101);  // measured 0.1000, one step behind, as in plain Bullet
}

// An infinite moment about a body axis (an inverse inertia of 0), in contact and on a joint.
TYPED_TEST(JointKinds, OfABodyWithAnInfiniteMoment) {
  auto& scene = this->scene_;
  btRigidBody& body =
      scene.add(1, btVector3(1, 0, 2), btTransform::getIdentity(), scene.box(vector(0.3, 0.3, 0.3)));
  body.setAngularVelocity(btVector3(3, 0, 4));
  scene.template join<btPoint2PointConstraint>(body, vector(0, 0, 0.2));
  const double start = omega_of(body).norm();
  for (int i = 0; i < 600; ++i) {
    scene.step(kDt);
    ASSERT_TRUE(omega_of(body).allFinite()) << i;
    ASSERT_LT(omega_of(body).norm(), start) << i;  // measured 4.93 of 5 rad/s; plain Bullet reaches 26.6
  }
}

// A disabled joint holds nothing: the body moves freely, bit for bit.
TYPED_TEST(JointKinds, DisabledLeavesTheBodyFree) {
  TypeParam free_scene;
  btRigidBody& free = free_scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  auto& hinge = this->scene_.template join<btHingeConstraint>(body, btVector3(0, 0, 0), btVector3(0, 0, 1));
  hinge.setEnabled(false);
  this->scene_.step(kDt, 60);
  free_scene.step(kDt, 60);
  EXPECT_TRUE(same_motion(body, free));
}

// A broken joint releases the body.
TYPED_TEST(JointKinds, BrokenLetsTheBodyGo) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  auto& hinge = this->scene_.template join<btHingeConstraint>(body, btVector3(0, 0, 0), btVector3(0, 0, 1));
  hinge.setBreakingImpulseThreshold(btScalar(0.01));
  this->scene_.step(kDt, 3);
  EXPECT_FALSE(hinge.isEnabled());
  const double start = energy_of(body);
  this->scene_.step(kDt, 600);
  // The body moves freely: measured 4.1e-8 in single, 8.9e-16 in double precision.
  EXPECT_NEAR(energy_of(body) / start, 1, by_precision(2e-7, 5e-15));
}

// Joints report the forces that they transmit. The joint of a level balance beam bears its weight.
TYPED_TEST(JointKinds, TellTheirForces) {
  auto& scene = this->scene_;
  set_gravity(scene);
  btRigidBody& beam =
      scene.add(2, vector(1, 1, 1), btTransform::getIdentity(), scene.box(vector(0.1, 0.1, 0.1)));
  auto& hinge = scene.template join<btHingeConstraint>(beam, btVector3(0, 0, 0), btVector3(0, 1, 0));
  btJointFeedback feedback;
  hinge.enableFeedback(true);
  hinge.setJointFeedback(&feedback);
  scene.step(kDt, 60);
  // measured 8.4e-7 in single, 0 in double precision
  EXPECT_NEAR(feedback.m_appliedForceBodyA.z(), 2 * kGravity, by_precision(1e-5, 1e-13));
  EXPECT_LT(feedback.m_appliedTorqueBodyA.length(), 1e-6);  // measured 0
}

}  // namespace
}  // namespace polhode::testing
