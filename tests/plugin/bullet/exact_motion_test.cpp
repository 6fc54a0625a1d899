// `exact` in free flight in Bullet's worlds: compares the library's state with the closed form in 50 digits,
// for both of Bullet's precisions.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "oracle/free_top.h"
#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"
#include "support/random_body.h"

namespace polhode::testing {
namespace {

const btScalar kDt = btScalar(1.0 / 60.0);
constexpr int kTenSeconds = 600;

Vector3 inertia_of(const btRigidBody& body) {
  return to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
}

/// A body in flight, and its exact motion from the start as rounded by Bullet.
struct Flight {
  explicit Flight(RotationControl& rotation, const btRigidBody& flying)
      : body(&flying),
        start(rotation.rotation_of(flying).state),
        truth(inertia_of(flying), start.q_WB, start.L_W) {}

  double attitude_error(RotationControl& rotation, int steps) const {
    return truth.attitude_error_after(rotation.rotation_of(*body).state.q_WB, steps, kDt);
  }
  // Returns the distance of Bullet's pose from the library's state.
  double shown_error(RotationControl& rotation) const {
    return angle_between(basis_of(*body), rotation.rotation_of(*body).state.R_WB);
  }

  const btRigidBody* body;
  RotationState start;
  oracle::FreeTop truth;
};

template <class Way>
class ExactMotion : public ::testing::Test {
 protected:
  Flight launch(const btVector3& inertia_B, const btVector3& omega_W,
                const btQuaternion& q_WB = btQuaternion::getIdentity()) {
    btRigidBody& body = scene_.add_free(inertia_B, omega_W, q_WB);
    scene_.rotation().set_scheme(body, "exact");
    return Flight(scene_.rotation(), body);
  }

  Way scene_;
};
TYPED_TEST_SUITE(ExactMotion, BothWays, WayName);

TYPED_TEST(ExactMotion, IsExactForTenSecondsInEitherPrecision) {
  std::vector<Flight> flights;
  flights.push_back(this->launch(btVector3(1, 2, 3), btVector3(3, 2, 4)));
  flights.push_back(this->launch(vector(0.4, 0.5, 0.8), vector(100, 120, 124.9639948)));
  this->scene_.step(kDt, kTenSeconds);
  RotationControl& rotation = this->scene_.rotation();
  for (const Flight& flight : flights) {
    const RotationState state = rotation.rotation_of(*flight.body).state;
    // measured 9.3e-15 and 2.8e-13 rad
    EXPECT_LE(flight.attitude_error(rotation, kTenSeconds), 1e-12);
    EXPECT_LE(std::abs(state.energy() / flight.start.energy() - 1.0), 4e-15);
    EXPECT_EQ(state.L_W, flight.start.L_W);
    // measured 2.2e-8 in single, 3.1e-17 in double precision
    EXPECT_LE(flight.shown_error(rotation), by_precision(1e-7, 1e-15));
    EXPECT_TRUE(shows(*flight.body, state));
  }
}

TYPED_TEST(ExactMotion, IsExactForTwoHundredRandomBodiesAtOnce) {
  RandomBody random(5);
  std::vector<Flight> flights;
  for (int i = 0; i < 200; ++i) {
    const Quaternion q_WB = random.q_WB();
    flights.push_back(
        this->launch(to_bullet(random.inertia_B()), to_bullet(random.omega_W()),
                     btQuaternion(static_cast<btScalar>(q_WB.x()), static_cast<btScalar>(q_WB.y()),
                                  static_cast<btScalar>(q_WB.z()), static_cast<btScalar>(q_WB.w()))));
  }
  this->scene_.step(kDt, kTenSeconds);
  std::vector<double> errors;
  for (const Flight& flight : flights) {
    errors.push_back(flight.attitude_error(this->scene_.rotation(), kTenSeconds));
    EXPECT_LE(flight.shown_error(this->scene_.rotation()), by_precision(1e-7, 1e-15));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LE(errors[100], 5e-14);    // measured 4.8e-15 rad
  EXPECT_LE(errors.back(), 2e-11);  // measured 4.3e-12 rad
}

TYPED_TEST(ExactMotion, KeepsEnergyAndMomentumForAMillionSteps) {
  const Flight flight = this->launch(btVector3(1, 2, 3), btVector3(3, 2, 4));
  this->scene_.step(kDt, 1000000);
  const RotationState state = this->scene_.rotation().rotation_of(*flight.body).state;
  // measured 4.8e-12 and 1.1e-11 rad
  EXPECT_LE(flight.attitude_error(this->scene_.rotation(), 1000000), 5e-11);
  EXPECT_LE(std::abs(state.energy() / flight.start.energy() - 1.0), 4e-15);
  EXPECT_EQ(state.L_W, flight.start.L_W);
}

TYPED_TEST(ExactMotion, IsTheDefault) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  EXPECT_EQ(this->scene_.rotation().rotation_of(body).scheme, "exact");
}

}  // namespace
}  // namespace polhode::testing
