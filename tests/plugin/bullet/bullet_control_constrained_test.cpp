// The scheme `bullet` also follows a plain Bullet world through joints and contacts: to rounding, until the
// scene itself amplifies small differences. A rod on a hinge stays within 800 ulp over 600 steps; each test
// states its own figure.
#include <gtest/gtest.h>

#include <limits>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr double kUlp = std::numeric_limits<btScalar>::epsilon();

/// Returns the largest distance over all bodies between two scenes of the same bodies, in ulp of a radian, of
/// a metre, and of the fastest velocity in the scene (at least 1 rad/s or m/s).
template <class Scene, class OtherScene>
double ulps_apart(const Scene& scene, const OtherScene& other) {
  double fastest = 1, apart = 0, velocities_apart = 0;
  for (std::size_t i = 0; i < scene.bodies().size(); ++i) {
    const btRigidBody& a = *scene.bodies()[i];
    const btRigidBody& b = *other.bodies()[i];
    const Vector3 velocity = to_double(b.getLinearVelocity()), omega_W = omega_of(b);
    fastest = std::max({fastest, velocity.norm(), omega_W.norm()});
    apart = std::max(
        {apart, angle_between(basis_of(a), basis_of(b)),
         (to_double(a.getWorldTransform().getOrigin()) - to_double(b.getWorldTransform().getOrigin()))
             .norm()});
    velocities_apart = std::max({velocities_apart, (to_double(a.getLinearVelocity()) - velocity).norm(),
                                 (omega_of(a) - omega_W).norm()});
  }
  return std::max(apart, velocities_apart / fastest) / kUlp;
}

template <class Way>
class BulletControlConstrained : public ::testing::Test {
 protected:
  template <class Build>
  void build(Build function) {
    ours_.rotation().set_default_scheme("bullet");
    function(ours_);
    function(bullets_);
    // Otherwise Bullet's solver turns penetrating bodies by an additional velocity.
    ours_.world().getSolverInfo().m_splitImpulse = false;
    bullets_.world().getSolverInfo().m_splitImpulse = false;
  }

  double worst_over(int steps, btScalar dt = btScalar(1.0 / 60)) {
    double worst = 0;
    for (int i = 0; i < steps; ++i) {
      ours_.step(dt);
      bullets_.step(dt);
      worst = std::max(worst, ulps_apart(ours_, bullets_));
    }
    return worst;
  }

  Way ours_;
  Scene<> bullets_;
};
TYPED_TEST_SUITE(BulletControlConstrained, BothWays, WayName);

TYPED_TEST(BulletControlConstrained, FollowsARodOnAHinge) {
  this->build([](auto& scene) { add_hinged_rod(scene, 20); });
  // measured 792 ulp in single, 250 in double precision
  EXPECT_LT(this->worst_over(600), by_precision(2500, 800));
}

TYPED_TEST(BulletControlConstrained, FollowsADrivenRod) {
  this->build([](auto& scene) {
    const HingedBody rod = add_hinged_rod(scene, 0);
    rod.hinge.enableAngularMotor(true, -20, 1);
  });
  // measured 76 ulp in single, 26 in double precision
  EXPECT_LT(this->worst_over(600), by_precision(250, 80));
}

// The pair tumbles, which amplifies rounding by a factor of ten thousand within a second.
TYPED_TEST(BulletControlConstrained, FollowsAWeldForASecond) {
  this->build([](auto& scene) { add_welded_pair(scene, 20); });
  // measured 6,985 ulp in single, 2,276 in double precision
  EXPECT_LT(this->worst_over(60), by_precision(10000, 7000));
}

TYPED_TEST(BulletControlConstrained, FollowsABodyOnAPointJointForASecond) {
  this->build([](auto& scene) { add_top(scene, 20); });
  // measured 139 ulp in single, 115 in double precision
  EXPECT_LT(this->worst_over(60), by_precision(400, 350));
}

TYPED_TEST(BulletControlConstrained, FollowsABoxThroughItsImpact) {
  this->build([](auto& scene) {
    set_gravity(scene);
    scene.add_floor();
    btRigidBody& box = scene.add_box(vector(0.2, 0.3, 0.5), 1,
                                     btTransform(btQuaternion(1, 2, 3, 4).normalized(), vector(0, 0, 0.8)));
    box.setAngularVelocity(btVector3(3, 2, 4));
  });
  // measured 68 ulp in single, 651 in double precision
  EXPECT_LT(this->worst_over(60), by_precision(200, 1000));
  EXPECT_GT(this->bullets_.world().getDispatcher()->getNumManifolds(), 0);
}

// Boxes that spin on the floor on four corners each.
TYPED_TEST(BulletControlConstrained, FollowsBoxesThatSpinOnTheFloor) {
  this->build([](auto& scene) {
    set_gravity(scene);
    scene.add_floor();
    for (int i = 0; i < 10; ++i) {
      btRigidBody& box = scene.add_box(vector(0.2, 0.3, 0.5), 1,
                                       btTransform(btQuaternion::getIdentity(), vector(3 * i, 0, 0.5)));
      box.setAngularVelocity(vector(0, 0, i));
    }
  });
  // measured 2,026 ulp in single, 149,641 in double precision
  EXPECT_LT(this->worst_over(60), by_precision(6000, 200000));
}

TYPED_TEST(BulletControlConstrained, FollowsAPileIntoItsFirstImpacts) {
  this->build([](auto& scene) {
    std::mt19937 random(5);
    add_random_drop(scene, 5, random);
  });
  EXPECT_LT(this->worst_over(30), by_precision(90, 60));  // measured 28 ulp in single, 21 in double precision
  ASSERT_GT(this->bullets_.world().getDispatcher()->getNumManifolds(), 0);
  // A pile amplifies differences with every impact: measured, over the next 30 steps, 4,707 ulp in single and
  // 1,318 in double precision.
  EXPECT_LT(this->worst_over(30), by_precision(15000, 4000));
}

TYPED_TEST(BulletControlConstrained, FollowsAPileThatSplitImpulsesPushApart) {
  this->build([](auto& scene) {
    std::mt19937 random(5);
    add_random_drop(scene, 5, random);
  });
  this->ours_.world().getSolverInfo().m_splitImpulse = true;
  this->bullets_.world().getSolverInfo().m_splitImpulse = true;
  // measured 104 ulp in single, 41 in double precision
  EXPECT_LT(this->worst_over(30), by_precision(300, 120));
}

}  // namespace
}  // namespace polhode::testing
