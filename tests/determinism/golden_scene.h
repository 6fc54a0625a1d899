#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "determinism/fnv1a.h"
#include "polhode/bullet/rotation_control.h"
#include "support/motion.h"
#include "support/scene.h"

/// A scene whose state after 1,000 steps is bit-identical in every build of the library. The start is
/// computed from decimal constants and integers, with the square root as the only function of the C library.
/// Each random number is drawn in its own statement, because compilers evaluate arguments in different
/// orders.
namespace polhode::testing {

inline constexpr int kGoldenSteps = 1000;

/// Knuth's MMIX linear congruential generator.
class MmixRandom {
 public:
  double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }
  btVector3 vector(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return testing::vector(x, y, z);
  }
  btQuaternion rotation() {
    const btVector3 v = vector(-1, 1);
    return btQuaternion(v.x(), v.y(), v.z(), static_cast<btScalar>(uniform(0.1, 1))).normalized();
  }

 private:
  std::uint64_t state_ = 1;
};

/// Kicks and brakes every fifth body in turn.
class GoldenKicks final : public btActionInterface {
 public:
  void updateAction(btCollisionWorld* world, btScalar /*dt*/) override {
    ++step_;
    for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
      btRigidBody* const body = btRigidBody::upcast(world->getCollisionObjectArray()[i]);
      if (body == nullptr || body->isStaticOrKinematicObject() || i % 5 != 3) continue;
      if ((i + step_) % 7 == 0) body->applyTorqueImpulse(vector(0.05, -0.02, 0.03));
      if ((i + step_) % 23 == 0) body->setAngularVelocity(body->getAngularVelocity() * btScalar(0.9));
    }
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

 private:
  int step_ = 0;
};

/// The golden scene in any Scene type; `rotation` is null for plain Bullet.
template <class AnyScene>
class GoldenScene {
 public:
  GoldenScene(AnyScene& scene, RotationControl* rotation) : scene_(scene), rotation_(rotation) {
    scene_.world().addAction(&kicks_);
    add_free_bodies();
    add_pile();
    add_hinges();
    add_top();
    add_locked_and_damped();
    choose_schemes();
  }
  ~GoldenScene() { scene_.world().removeAction(&kicks_); }
  GoldenScene(const GoldenScene&) = delete;
  GoldenScene& operator=(const GoldenScene&) = delete;

  /// Returns a hash of the states at every hundredth step.
  std::uint64_t hash_after(int steps) {
    Fnv1a hash;
    for (int step = 1; step <= steps; ++step) {
      apply_torques(step);
      scene_.step(btScalar(1.0 / 60));
      if (step % 100 == 0 || step == steps) {
        for (const auto& body : scene_.bodies()) add(hash, *body);
      }
    }
    return hash.value();
  }

 private:
  static constexpr int kFreeBodies = 660;  // enough work for several threads
  static constexpr int kBoxes = 36;

  btRigidBody& add(const btVector3& inertia_B, const btQuaternion& q_WB, const btVector3& origin,
                   const btVector3& omega_W) {
    btRigidBody& body = scene_.add(1, inertia_B, btTransform(q_WB, origin), small_box_);
    body.setAngularVelocity(omega_W);
    return body;
  }

  // Bodies that never touch. Their spins cover all magnitudes, so that some schemes diverge and `matrix`
  // swells.
  void add_free_bodies() {
    for (int i = 0; i < kFreeBodies; ++i) {
      const btVector3 inertia_B = random_.vector(0.5, 3);
      const btQuaternion q_WB = random_.rotation();
      const double speed = 0.5 * (1 << i % 7);
      const int row = i / 30;
      add(inertia_B, q_WB, vector(5 * (i % 30), 5 * row, 100), random_.vector(-speed, speed));
    }
  }

  void add_pile() {
    scene_.add_floor().setFriction(btScalar(0.5));
    for (int i = 0; i < kBoxes; ++i) {
      const btVector3 half_extents = random_.vector(0.2, 0.5);
      const int layer = i / 9;
      const int row = i / 3 % 3;
      const btVector3 origin = vector(i % 3 + 0.1 * layer, row - 0.1 * layer, 1 + 1.2 * layer);
      btRigidBody& box = scene_.add_box(half_extents, btScalar(1.5), btTransform(random_.rotation(), origin));
      box.setGravity(vector(0, 0, -9.81));
      box.setAngularVelocity(random_.vector(-4, 4));
      if (i % 6 == 0) box.forceActivationState(ACTIVE_TAG);  // allow sleeping
    }
  }

  // Rods mounted askew, at speeds that dt resolves and one that dt does not resolve; a motor between two
  // bodies.
  void add_hinges() {
    const btQuaternion askew = btQuaternion(btScalar(0.4), 0, 0, btScalar(0.9)).normalized();
    int place = 0;
    for (const double speed : {5.0, 20.0, 60.0}) {
      btRigidBody& rod = add(vector(1, 0.1, 1), askew, vector(-20, 20 * ++place, 50), vector(0, 0, speed));
      const btVector3 axis_B = rod.getWorldTransform().getBasis().transpose() * vector(0, 0, 1);
      scene_.template join<btHingeConstraint>(rod, vector(0, 0, 0), axis_B);
    }
    btRigidBody& stator = add(vector(3, 2, 4), random_.rotation(), vector(-40, 0, 50), vector(0, 0.2, 0));
    btRigidBody& rotor = add(vector(0.5, 0.7, 0.3), stator.getWorldTransform().getRotation(),
                             vector(-40, 0, 50), vector(0, 0.2, 0));
    auto& motor = scene_.template join<btHingeConstraint>(stator, rotor, vector(0, 0, 0), vector(0, 0, 0),
                                                          vector(0, 0, 1), vector(0, 0, 1));
    motor.enableAngularMotor(true, 15, btScalar(0.2));
  }

  // A tilted top on a point joint, spinning about its own axis.
  void add_top() {
    const btQuaternion leaning = btQuaternion(0, btScalar(0.25), 0, btScalar(0.97)).normalized();
    const btTransform tilt(leaning);
    const btVector3 axis_W = tilt * vector(0, 0, 1);
    btRigidBody& top =
        add(vector(0.005, 0.005, 0.008), leaning, vector(-60, 0, 50) + axis_W * btScalar(0.05), axis_W * 25);
    top.setGravity(vector(0, 0, -9.81));
    scene_.template join<btPoint2PointConstraint>(top, vector(0, 0, -0.05));
  }

  void add_locked_and_damped() {
    for (int i = 0; i < 4; ++i) {
      const btVector3 inertia_B = random_.vector(1, 3);
      const btQuaternion q_WB = random_.rotation();
      const btVector3 omega_W = random_.vector(-6, 6);
      const int y_factor = i / 2;
      const btVector3 factor = vector(1, y_factor, i % 2);
      btRigidBody& locked = add(inertia_B, q_WB, vector(-80, 10 * i, 50), omega_W * factor);
      locked.setAngularFactor(factor);
      btRigidBody& damped = add(inertia_B, q_WB, vector(-100, 10 * i, 50), omega_W);
      damped.setDamping(btScalar(0.1), btScalar(0.05) * static_cast<btScalar>(i));
    }
  }

  // Uses every scheme for the free bodies and the pile, and the default scheme for joints.
  void choose_schemes() {
    if (rotation_ == nullptr) return;
    const auto& schemes = built_in_schemes();
    for (std::size_t i = 0; i <= kFreeBodies + kBoxes; ++i) {
      btRigidBody& body = *scene_.bodies()[i];
      if (!body.isStaticObject()) rotation_->set_scheme(body, schemes[i % schemes.size()]);
    }
  }

  void apply_torques(int step) {
    const auto level = static_cast<btScalar>(step % 11 - 5);
    for (std::size_t i = 1; i < kFreeBodies; i += 9) {
      scene_.bodies()[i]->applyTorque(vector(0.3, 0.2, -0.1) * level);
    }
  }

  static void add(Fnv1a& hash, const btVector3& vector) {
    hash.add_bytes(vector.m_floats, 3 * sizeof(btScalar));  // the fourth component is padding
  }

  template <class Matrix>
  static void add_coefficients(Fnv1a& hash, const Matrix& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) hash.add<double>(matrix.data()[i]);
  }

  void add(Fnv1a& hash, const btRigidBody& body) const {
    for (int row = 0; row < 3; ++row) add(hash, body.getWorldTransform().getBasis()[row]);
    add(hash, body.getWorldTransform().getOrigin());
    add(hash, body.getLinearVelocity());
    add(hash, body.getAngularVelocity());
    if (rotation_ == nullptr || !rotation_->manages(body)) return;
    const BodyRotation rotation = rotation_->rotation_of(body);
    add_coefficients(hash, rotation.state.q_WB.coeffs());
    add_coefficients(hash, rotation.state.R_WB);
    add_coefficients(hash, rotation.state.omega_W);
    add_coefficients(hash, rotation.state.L_W);
    hash.add(rotation.steps);
    hash.add(rotation.unresolved_steps);
  }

  AnyScene& scene_;
  RotationControl* rotation_;
  MmixRandom random_;
  GoldenKicks kicks_;
  btCollisionShape& small_box_ = scene_.box(vector(0.1, 0.1, 0.1));
};

}  // namespace polhode::testing
