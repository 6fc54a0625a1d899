#include "multithreading/plays.h"

#include <cmath>
#include <limits>

#include "support/motion.h"
#include "support/random_body.h"

namespace polhode::testing {

namespace {

constexpr int kFreeBodies = 2000;
constexpr int kPiles = 16;
constexpr int kBoxesInPile = 33;
constexpr int kStepOfNan = 10;

// The periods are coprime with each other and with the number of schemes, 11, so that every combination
// occurs with every scheme.
bool is_kicked(int body) {
  return body % 7 == 3;
}
bool is_under_torque(int body) {
  return body % 17 == 4;
}
bool is_damped(int body) {
  return body % 5 == 2;
}
bool is_asleep(int body) {
  return body % 13 == 6;
}
bool tires(int body) {
  return body % 13 == 8;
}
bool gets_nan(int body) {
  return body % 401 == 150;
}

void choose_scheme(MtScene& scene, btRigidBody& body, int number) {
  const auto& schemes = built_in_schemes();
  scene.rotation().set_scheme(body, schemes[static_cast<std::size_t>(number) % schemes.size()]);
}

btQuaternion to_bullet(const Quaternion& q_WB) {
  return {static_cast<btScalar>(q_WB.x()), static_cast<btScalar>(q_WB.y()), static_cast<btScalar>(q_WB.z()),
          static_cast<btScalar>(q_WB.w())};
}

void set_up_free_bodies(MtScene& scene) {
  RandomBody random(1);
  btCollisionShape& shape = scene.box(btVector3(1, 1, 1));
  for (int i = 0; i < kFreeBodies; ++i) {
    const btTransform pose(to_bullet(random.q_WB()), vector(10 * (i % 50), 10 * (i / 50), 0));
    const btVector3 inertia_B = polhode::to_bullet(random.inertia_B());
    btRigidBody& body = scene.add(1, inertia_B, pose, shape);
    const double slowness = tires(i) ? 1e-3 : 1.0;
    body.setAngularVelocity(polhode::to_bullet(Vector3(slowness * random.omega_W())));
    choose_scheme(scene, body, i);
    if (is_damped(i)) body.setDamping(btScalar(0.1), btScalar(0.3));
    if (is_asleep(i)) {
      body.forceActivationState(ISLAND_SLEEPING);
    } else if (!tires(i)) {
      body.setActivationState(DISABLE_DEACTIVATION);
    }
  }
}

void act_on_free_bodies(MtScene& scene, int step) {
  for (int i = 0; i < kFreeBodies; ++i) {
    btRigidBody& body = *scene.bodies()[static_cast<std::size_t>(i)];
    if (is_asleep(i)) continue;
    if (is_kicked(i)) body.applyTorqueImpulse(vector(std::sin(step + i), 0.1, -0.2));
    if (is_under_torque(i)) body.applyTorque(vector(0.3, std::cos(0.01 * i), -0.5));
    if (gets_nan(i) && step == kStepOfNan) {
      body.setAngularVelocity(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
    }
  }
}

void set_up_piles(MtScene& scene) {
  scene.world().setGravity(btVector3(0, 0, -10));
  scene.add(0, btVector3(0, 0, 0), btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)),
            scene.box(btVector3(500, 500, 1)));
  RandomBody random(2);
  for (int i = 0; i < kPiles * kBoxesInPile; ++i) {
    const int level = i / kPiles;
    btCollisionShape& shape = scene.box(vector(0.2, 0.3 + 0.005 * level, 0.5));
    const btScalar mass = 1 + static_cast<btScalar>(level) / 4;
    btVector3 inertia_B;
    shape.calculateLocalInertia(mass, inertia_B);
    const btTransform pose(to_bullet(random.q_WB()),
                           vector(40 * (i % kPiles) + 0.1 * (level % 3), 0.1 * (level % 4), 1 + 0.7 * level));
    btRigidBody& body = scene.add(mass, inertia_B, pose, shape);
    body.setFriction(btScalar(0.6));
    body.setAngularVelocity(vector(3, level % 7 - 3, 2));
  }
}

void set_up_piles_with_schemes(MtScene& scene) {
  set_up_piles(scene);
  if (!scene.is_rotated()) return;
  for (std::size_t i = 1; i < scene.bodies().size(); ++i) {
    choose_scheme(scene, *scene.bodies()[i], static_cast<int>(i));
  }
}

}  // namespace

const Play& free_bodies() {
  static const Play play{set_up_free_bodies, act_on_free_bodies, btScalar(1.0 / 60.0), kSteps};
  return play;
}

const Play& piles() {
  static const Play play{set_up_piles_with_schemes, [](MtScene& /*scene*/, int /*step*/) {},
                         btScalar(1.0 / 60.0), kSteps / 2};
  return play;
}

}  // namespace polhode::testing
