// Snapshots of bodies with torque laws and motors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "polhode/torque_laws.h"
#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/motion.h"
#include "support/same_bits.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);

template <class Way>
class DrivenSnapshot : public ::testing::Test {};
TYPED_TEST_SUITE(DrivenSnapshot, BothWays, WayName);

// Free, hinged and resting bodies with laws, rotors, motors, or all of these.
template <class Way>
void add_driven(Way& way) {
  set_gravity(way);
  way.add_floor();
  const TorqueLaw law = [](const TorqueLawInput& motion) {
    return Torque(BodyTorque{-0.2 * motion.omega_B()}) +
           Torque(WorldTorque{Vector3(std::sin(3.0 * motion.time_s), 0.1, 0.0)});
  };
  for (int i = 0; i < 12; ++i) {
    btRigidBody& body = way.add_box(vector(0.3, 0.4, 0.5), 1,
                                    btTransform(btQuaternion(1, 2, btScalar(i), 4).normalized(),
                                                vector(3.0 * i, 0, i % 3 == 0 ? 0.5 : 40)));
    body.setAngularVelocity(vector(1, i % 4, 2));
    way.rotation().set_scheme(body, i % 2 == 0 ? "exact" : "implicit_midpoint");
    if (i % 4 != 1) way.rotation().set_torque_law(body, law);
    if (i % 4 != 0) way.rotation().set_rotor_momentum(body, {0.3, 0.1, -0.2}, RotorChange::by_motor);
    if (i % 4 >= 2) way.rotation().set_rotor_torque(body, {0.0, 0.05, 0.1});
    if (i % 3 == 2)
      way.template join<btHingeConstraint>(body, vector(0, 0, 0), vector(0, 0, 1)).setEnabled(true);
  }
}

TYPED_TEST(DrivenSnapshot, GoesOnWithTheSameBits) {
  TypeParam way;
  add_driven(way);
  way.step(kStep, 25);
  const Snapshot snapshot = way.rotation().save_world();
  const double time_s = way.rotation().time();
  const auto went_on = run(way, 200, kStep);
  way.rotation().restore_world(snapshot);
  EXPECT_EQ(way.rotation().time(), time_s);
  EXPECT_EQ(way.rotation().save_world(), snapshot);
  EXPECT_EQ(first_difference(went_on, run(way, 200, kStep)), 0);
}

// The application has given the twin's bodies the same laws; rotors and motors are part of the snapshot.
TYPED_TEST(DrivenSnapshot, BringsRotorsToATwinThatHasNone) {
  TypeParam way;
  btRigidBody& body = way.add_free(vector(1, 2, 3), vector(1, 2, 3));
  way.rotation().set_rotor_momentum(body, {2.0, 0.5, -1.0}, RotorChange::by_motor);
  way.rotation().set_rotor_torque(body, {0.1, 0.0, 0.2});
  way.step(kStep, 10);
  TypeParam twin;
  btRigidBody& other = twin.add_free(vector(1, 2, 3), vector(0, 0, 0));
  twin.rotation().restore(other, way.rotation().save(body));
  const auto agree = [&] {
    return same_bits(way.rotation().rotation_of(body).state, twin.rotation().rotation_of(other).state);
  };
  EXPECT_TRUE(agree());
  way.step(kStep, 50);
  twin.step(kStep, 50);
  EXPECT_TRUE(agree());
}

TYPED_TEST(DrivenSnapshot, OfABodyWithoutRotorsTakesThemAway) {
  TypeParam way;
  btRigidBody& body = way.add_free(vector(1, 2, 3), vector(1, 2, 3));
  way.step(kStep, 10);
  const Snapshot snapshot = way.rotation().save(body);
  way.step(kStep, 20);
  const RotationState went_on = way.rotation().rotation_of(body).state;
  way.rotation().set_rotor_momentum(body, {2.0, 0.5, -1.0}, RotorChange::from_outside);
  way.rotation().set_rotor_torque(body, {0.1, 0.0, 0.2});
  way.step(kStep, 10);
  way.rotation().restore(body, snapshot);
  way.step(kStep, 20);
  EXPECT_TRUE(same_bits(way.rotation().rotation_of(body).state, went_on));
  EXPECT_NO_THROW(way.rotation().set_scheme(body, "matrix"));
}

TYPED_TEST(DrivenSnapshot, SetsTheStateOfABodyWithRotors) {
  TypeParam way;
  btRigidBody& body = way.add_free(vector(1, 2, 3), vector(1, 2, 3));
  way.rotation().set_rotor_momentum(body, {2.0, 0.5, -1.0}, RotorChange::from_outside);
  way.rotation().set_rotation(body, Quaternion(0.5, 0.5, 0.5, 0.5), {0.1, 0.2, 0.3});
  const RotationState state = way.rotation().rotation_of(body).state;
  const Vector3 expected_L_W =
      state.R_WB * (Vector3(1, 2, 3).cwiseProduct(state.R_WB.transpose() * Vector3(0.1, 0.2, 0.3)) +
                    Vector3(2.0, 0.5, -1.0));
  EXPECT_LE((state.L_W - expected_L_W).norm(), 1e-6);
  way.step(kStep, 3);
  EXPECT_EQ(way.rotation().rotation_of(body).state.L_W, state.L_W);
}

}  // namespace
}  // namespace polhode::testing
