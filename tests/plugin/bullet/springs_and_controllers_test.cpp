// Torques that depend on pose or velocity: springs keep their energy, damped springs come to rest, and a
// controlled plate hovers.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);

// Returns the shortest rotation from the identity, rad.
Vector3 rotation_vector_W(const btRigidBody& body) {
  return turn_between(Matrix3::Identity(), basis_of(body));
}

template <class Way>
class Springs : public ::testing::Test {
 protected:
  Way scene_;
};
TYPED_TEST_SUITE(Springs, BothWays, WayName);

// 1 Hz: its stiffness is (2 pi)^2 I.
TYPED_TEST(Springs, SwingForTwentySecondsAsTheyBegan) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 1, 1), btVector3(0, 0, 0),
                                            btQuaternion(btVector3(1, 0, 0), btScalar(0.1)));
  Range early, late;
  for (int i = 0; i < 1200; ++i) {
    body.applyTorque(vector(-39.48 * rotation_vector_W(body).x(), 0, 0));
    this->scene_.step(kDt);
    (i < 60 ? early : late).add(rotation_vector_W(body).x());
  }
  // measured 0.10002 in the first second and 0.1001 later, as in plain Bullet
  EXPECT_NEAR(early.highest, 0.1, 5e-5);
  EXPECT_NEAR(late.highest, 0.1, 4e-4);
  EXPECT_NEAR(late.lowest, -0.1, 4e-4);
}

TYPED_TEST(Springs, OfAnAsymmetricBodyAboutAnAskewAxisGainNothing) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0),
                                            btQuaternion(btVector3(1, 2, 1).normalized(), btScalar(0.1)));
  Range angle;
  for (int i = 0; i < 1200; ++i) {
    body.applyTorque(to_bullet(Vector3(-39.48 * rotation_vector_W(body))));
    this->scene_.step(kDt);
    angle.add(rotation_vector_W(body).norm());
  }
  EXPECT_LT(angle.highest, 0.1);  // measured 0.0994, in the first step
}

// Forces at four corners, each proportional to how low the corner is.
TYPED_TEST(Springs, LetAPlateHover) {
  auto& scene = this->scene_;
  set_gravity(scene);
  btRigidBody& plate = scene.add_box(
      vector(1, 0.2, 2), 10, btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(1e-3)), vector(0, 0, 1)));
  plate.setGravity(btVector3(0, btScalar(-kGravity), 0));
  Range tilt, height;
  plate.getWorldTransform().setOrigin(btVector3(0, 1, 0));
  for (int i = 0; i < 3600; ++i) {
    for (const double x : {-1.0, 1.0}) {
      for (const double z : {-2.0, 2.0}) {
        const btVector3 arm = plate.getWorldTransform().getBasis() * vector(x, 0, z);
        const double corner = plate.getWorldTransform().getOrigin().y() + arm.y();
        plate.applyForce(vector(0, 100 * (1.245 - corner), 0), arm);
      }
    }
    scene.step(kDt);
    tilt.add(angle_between_axes(basis_of(plate).col(1), Vector3::UnitY()));
    height.add(plate.getWorldTransform().getOrigin().y());
  }
  EXPECT_LT(tilt.highest, 1.1e-3);  // measured 1.004e-3 rad; it starts with 1e-3
  // measured 0.9995 to 1.0000
  EXPECT_NEAR(height.highest, 1, 1e-5);
  EXPECT_NEAR(height.lowest, 1, 1e-3);
}

/// PD control about x towards the identity, from 0.1 rad. Returns the largest angle of the last two seconds.
template <class AnyScene>
double control(AnyScene& scene, double hertz, double damping_ratio) {
  btRigidBody& body =
      scene.add_free(btVector3(1, 1, 1), btVector3(0, 0, 0), btQuaternion(btVector3(1, 0, 0), btScalar(0.1)));
  const double rate = 2 * M_PI * hertz;
  Range late;
  for (int i = 0; i < 1200; ++i) {
    const double angle = rotation_vector_W(body).x();
    const double torque = -rate * rate * angle - 2 * damping_ratio * rate * omega_of(body).x();
    body.applyTorque(vector(torque, 0, 0));
    scene.step(kDt);
    if (i >= 1080) late.add(std::abs(rotation_vector_W(body).x()));
  }
  return late.highest;
}

TYPED_TEST(Springs, WithDampingComeToRestAsInPlainBullet) {
  struct Controller {
    double hertz, damping_ratio;
  };
  for (const Controller& controller : {Controller{2, 0.05}, Controller{4, 0.1}}) {
    TypeParam scene;
    Scene<> plain;
    const double ours = control(scene, controller.hertz, controller.damping_ratio);
    const double bullets = control(plain, controller.hertz, controller.damping_ratio);
    // measured 1.0e-6 and 2.7e-22 rad, as in plain Bullet
    EXPECT_LT(ours, 2e-6) << controller.hertz;
    EXPECT_LT(ours, 1.01 * bullets) << controller.hertz;
  }
}

// A spring between two bodies, by equal and opposite torques.
TYPED_TEST(Springs, BetweenTwoBodiesKeepMomentumAndEnergy) {
  auto& scene = this->scene_;
  btRigidBody& a =
      scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 1), btQuaternion(btVector3(1, 0, 0), btScalar(0.2)));
  btRigidBody& b = scene.add_free(btVector3(2, 1, 1), btVector3(0, 0, 1));
  const Vector3 momentum_W = shown_angular_momentum_W(a) + shown_angular_momentum_W(b);
  const auto energy = [&] {
    const double angle = angle_between(basis_of(b), basis_of(a));
    return energy_of(a) + energy_of(b) + 0.5 * 40 * angle * angle;
  };
  const double start = energy();
  Range gained, momentum_off;
  for (int i = 0; i < 1200; ++i) {
    const Vector3 torque = -40 * turn_between(basis_of(b), basis_of(a));
    a.applyTorque(to_bullet(torque));
    b.applyTorque(to_bullet(Vector3(-torque)));
    scene.step(kDt);
    gained.add(energy() / start);
    momentum_off.add((shown_angular_momentum_W(a) + shown_angular_momentum_W(b) - momentum_W).norm());
  }
  // measured 0.982 to 1.020, plain Bullet 0.981 to 1.035; it oscillates, since the velocity is half a step
  // late
  EXPECT_NEAR(gained.highest, 1, 0.03);
  EXPECT_NEAR(gained.lowest, 1, 0.03);
  // measured 5.4e-7 in single, 8.7e-15 in double precision; plain Bullet 0.045
  EXPECT_LT(momentum_off.highest, by_precision(2e-6, 3e-14));
}

// Bullet's own six-degree-of-freedom springs are rows in its solver.
TYPED_TEST(Springs, OfBulletsSixDegreeJointGainNoEnergy) {
  auto& scene = this->scene_;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0),
                                     btQuaternion(btVector3(1, 2, 1).normalized(), btScalar(0.1)));
  const btTransform frame_B(body.getWorldTransform().getBasis().transpose());
  auto& spring = scene.template join<btGeneric6DofSpring2Constraint>(body, frame_B);
  for (int axis = 3; axis < 6; ++axis) {
    spring.setLimit(axis, 1, -1);
    spring.enableSpring(axis, true);
    spring.setStiffness(axis, btScalar(39.48));
    spring.setDamping(axis, 0);
    spring.setEquilibriumPoint(axis, 0);
  }
  body.setAngularVelocity(btVector3(btScalar(0.5), btScalar(0.3), btScalar(-0.4)));
  const double start = energy_of(body);
  Range energy;
  for (int i = 0; i < 1200; ++i) {
    scene.step(kDt);
    energy.add(energy_of(body));
  }
  // measured 0.431, plain Bullet 0.439 J; the start has 0.421 J, and the spring holds about 0.2 J
  EXPECT_LT(energy.highest, start + 0.02);
}

}  // namespace
}  // namespace polhode::testing
