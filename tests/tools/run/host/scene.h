#pragma once

#include <btBulletDynamicsCommon.h>

/// The scene of the host programs: plain Bullet, as a user has it, without this library.
namespace polhode::run_test {

inline constexpr btScalar kDt = btScalar(1) / 60;
inline constexpr int kSteps = 600;

/// The objects that a world uses, and which must outlive it.
struct Surroundings {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
};

/// A free body that tumbles: initially it spins almost about its middle axis.
class TumblingBody {
 public:
  TumblingBody() {
    body_.setAngularVelocity(btVector3(btScalar(0.01), 5, btScalar(0.01)));
    body_.setActivationState(DISABLE_DEACTIVATION);
    energy_at_start_ = energy();
  }

  btRigidBody& body() { return body_; }
  /// Returns 1 if the rotational energy is unchanged.
  double energy_ratio() const { return energy() / energy_at_start_; }

 private:
  static btVector3 inertia() { return btVector3(1, 2, 3); }
  double energy() const {
    const btVector3 omega_B = body_.getWorldTransform().getBasis().transpose() * body_.getAngularVelocity();
    double energy = 0.0;
    for (int axis = 0; axis < 3; ++axis) energy += 0.5 * inertia()[axis] * omega_B[axis] * omega_B[axis];
    return energy;
  }

  btSphereShape shape_{1};
  btRigidBody body_{btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape_, inertia())};
  double energy_at_start_ = 0.0;
};

/// A world with one tumbling body.
class TumblingWorld {
 public:
  TumblingWorld() {
    world_.setGravity(btVector3(0, 0, 0));
    world_.addRigidBody(&body_.body());
  }
  ~TumblingWorld() { world_.removeRigidBody(&body_.body()); }
  TumblingWorld(const TumblingWorld&) = delete;
  TumblingWorld& operator=(const TumblingWorld&) = delete;

  btDiscreteDynamicsWorld& world() { return world_; }
  void step() { world_.stepSimulation(kDt, 0); }
  double energy_ratio() const { return body_.energy_ratio(); }

 private:
  Surroundings surroundings_;
  btDiscreteDynamicsWorld world_{&surroundings_.dispatcher, &surroundings_.broadphase, &surroundings_.solver,
                                 &surroundings_.configuration};
  TumblingBody body_;
};

}  // namespace polhode::run_test
