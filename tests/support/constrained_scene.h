#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "oracle/heavy_top.h"
#include "support/motion.h"
#include "support/scene.h"
#include "support/uniform.h"

/// Scenes with joints, locked axes, contacts and springs. Each builder takes any scene, with or without the
/// library; z is up.
namespace polhode::testing {

constexpr double kGravity = 9.81;

template <class AnyScene>
void set_gravity(AnyScene& scene) {
  scene.world().setGravity(vector(0, 0, -kGravity));
}

/// Returns kinetic and potential energy of a body from Bullet's velocity, J.
inline double energy_of(const btRigidBody& body, double gravity = 0) {
  const Vector3 inertia_B = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
  const Vector3 omega_B = basis_of(body).transpose() * omega_of(body);
  const double mass = 1.0 / static_cast<double>(body.getInvMass());
  return 0.5 * omega_B.dot(inertia_B.cwiseProduct(omega_B)) +
         0.5 * mass * to_double(body.getLinearVelocity()).squaredNorm() +
         mass * gravity * static_cast<double>(body.getWorldTransform().getOrigin().z());
}

/// Returns the angular momentum about the centre of mass from Bullet's velocity.
inline Vector3 shown_angular_momentum_W(const btRigidBody& body) {
  const Vector3 inertia_B = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
  return basis_of(body) * inertia_B.cwiseProduct(basis_of(body).transpose() * omega_of(body));
}

inline double angle_between_axes(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Minimum, maximum and last value of a quantity over a run.
struct Range {
  double lowest = 1e300;
  double highest = -1e300;
  double last = 0;

  void add(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    last = value;
  }
};

/// A body on a hinge along the world's z axis through its centre.
struct HingedBody {
  btRigidBody& body;
  btHingeConstraint& hinge;
  Vector3 axis_B;

  /// Returns the angle between the body's axis and the hinge axis, rad.
  double axis_off() const { return angle_between_axes(basis_of(body) * axis_B, Vector3::UnitZ()); }
};

template <class AnyScene>
HingedBody add_hinged(AnyScene& scene, const btVector3& inertia_B, const btQuaternion& q_WB,
                      const btVector3& omega_W) {
  btRigidBody& body = scene.add_free(inertia_B, omega_W, q_WB);
  const btVector3 axis_B = body.getWorldTransform().getBasis().transpose() * btVector3(0, 0, 1);
  auto& hinge = scene.template join<btHingeConstraint>(body, btVector3(0, 0, 0), axis_B);
  scene.world().getSolverInfo().m_numIterations = 50;
  return {body, hinge, to_double(axis_B)};
}

/// Adds a rod mounted askew: the hinge axis is tilted by `tilt` from a principal axis across the rod.
template <class AnyScene>
HingedBody add_hinged_rod(AnyScene& scene, double speed, double tilt = M_PI / 4) {
  return add_hinged(scene, vector(1, 0.1, 1), btQuaternion(btVector3(1, 0, 0), btScalar(tilt)),
                    vector(0, 0, speed));
}

/// Two bodies welded together.
struct WeldedPair {
  btRigidBody& a;
  btRigidBody& b;
  Matrix3 R_AB;

  double misalignment() const { return angle_between(Matrix3(basis_of(a).transpose() * basis_of(b)), R_AB); }
};

/// Two bodies a metre apart, with their axes askew, that rotate together about the world's y axis.
template <class AnyScene>
WeldedPair add_welded_pair(AnyScene& scene, double speed) {
  const btVector3 omega_W = vector(0, speed, 0);
  const auto part = [&](double side) -> btRigidBody& {
    const btTransform pose(btQuaternion(btVector3(0, 0, 1), btScalar(-0.6 * side)), vector(0.5 * side, 0, 0));
    btRigidBody& body = scene.add(1, vector(0.02, 0.1, 0.11), pose, scene.box(vector(0.1, 0.1, 0.1)));
    body.setAngularVelocity(omega_W);
    body.setLinearVelocity(omega_W.cross(pose.getOrigin()));
    return body;
  };
  btRigidBody& a = part(-1);
  btRigidBody& b = part(1);
  scene.template join<btFixedConstraint>(a, b, a.getWorldTransform().inverse(),
                                         b.getWorldTransform().inverse());
  scene.world().getSolverInfo().m_numIterations = 50;
  return {a, b, basis_of(a).transpose() * basis_of(b)};
}

/// A symmetric top on a point joint, released in its steady precession at a tilt of 0.5 rad.
struct Top {
  static constexpr double kTilt = 0.5;
  btRigidBody& body;
  double precession;  ///< rad/s

  Vector3 axis_W() const { return basis_of(body).col(2); }
  double tilt() const { return angle_between_axes(axis_W(), Vector3::UnitZ()); }
  double azimuth() const { return std::atan2(axis_W().y(), axis_W().x()); }
};

template <class AnyScene>
Top add_top(AnyScene& scene, double spin) {
  set_gravity(scene);
  const oracle::HeavyTop top{0.005, 0.008, 1.0, 0.05, kGravity};
  const oracle::SteadyTop start = oracle::steadily_precessing(top, Top::kTilt, spin);
  const btTransform pose(btQuaternion(btVector3(0, 1, 0), btScalar(Top::kTilt)),
                         to_bullet(Vector3(top.length * start.axis_W)));
  btRigidBody& body = scene.add(1, vector(top.transverse, top.transverse, top.axial), pose,
                                scene.box(vector(0.01, 0.01, 0.01)));
  body.setAngularVelocity(to_bullet(start.omega_W));
  body.setLinearVelocity(to_bullet(start.velocity_W));
  scene.template join<btPoint2PointConstraint>(body, vector(0, 0, -top.length));
  scene.world().getSolverInfo().m_numIterations = 50;
  return {body, oracle::slow_precession(top, Top::kTilt, spin)};
}

/// A wheel on a free hub, spinning about their common x axis. Their total angular momentum is constant.
struct Gimbal {
  btRigidBody& hub;
  btRigidBody& wheel;

  double axis_off() const {
    return angle_between_axes(Vector3(basis_of(hub).col(0)), Vector3(basis_of(wheel).col(0)));
  }
  double energy() const { return energy_of(hub) + energy_of(wheel); }
  Vector3 angular_momentum_W() const {
    return shown_angular_momentum_W(hub) + shown_angular_momentum_W(wheel);
  }
};

template <class AnyScene>
Gimbal add_gimbal(AnyScene& scene, double spin) {
  const auto part = [&](btScalar mass, const btVector3& inertia_B, const btVector3& omega_W) -> btRigidBody& {
    btRigidBody& body =
        scene.add(mass, inertia_B, btTransform::getIdentity(), scene.box(vector(0.1, 0.1, 0.1)));
    body.setAngularVelocity(omega_W);
    return body;
  };
  btRigidBody& hub = part(10, vector(1, 1.2, 1.5), vector(0, 0, 0.5));
  btRigidBody& wheel = part(1, vector(0.04, 0.02, 0.02), vector(spin, 0, 0.5));
  scene.template join<btHingeConstraint>(hub, wheel, btVector3(0, 0, 0), btVector3(0, 0, 0),
                                         btVector3(1, 0, 0), btVector3(1, 0, 0));
  scene.world().getSolverInfo().m_numIterations = 50;
  return {hub, wheel};
}

/// Adds a body that cannot turn about those world axes whose factor is 0.
template <class AnyScene>
btRigidBody& add_locked(AnyScene& scene, const btVector3& angular_factor, const btVector3& omega_W) {
  btRigidBody& body =
      scene.add_free(btVector3(1, 2, 3), omega_W,
                     btQuaternion(btScalar(0.2), btScalar(-0.3), btScalar(0.25), btScalar(0.9)).normalized());
  body.setAngularFactor(angular_factor);
  return body;
}

/// A stack of boxes; the first body is the floor.
template <class AnyScene>
void add_stack(AnyScene& scene, int count, const btVector3& half_extents = vector(0.5, 0.4, 0.3)) {
  set_gravity(scene);
  scene.add_floor().setFriction(btScalar(0.5));
  for (int i = 0; i < count; ++i) {
    const btVector3 origin(0, 0, half_extents.z() * static_cast<btScalar>(2 * i + 1));
    scene.add_box(half_extents, 1, btTransform(btQuaternion::getIdentity(), origin));
  }
}

/// The displacement of a stack from its initial place.
struct StackWander {
  double lean = 0;    ///< rad, of the worst box
  double wander = 0;  ///< m, horizontally, of the worst box
};

template <class AnyScene>
StackWander wander_of(const AnyScene& scene) {
  StackWander worst;
  for (std::size_t i = 1; i < scene.bodies().size(); ++i) {
    const btRigidBody& box = *scene.bodies()[i];
    worst.lean = std::max(worst.lean, angle_between_axes(Vector3(basis_of(box).col(2)), Vector3::UnitZ()));
    const btVector3 origin = box.getWorldTransform().getOrigin();
    worst.wander = std::max<double>(worst.wander, std::hypot(origin.x(), origin.y()));
  }
  return worst;
}

/// A coin that spins on its edge, leaning, on a rough floor.
template <class AnyScene>
btRigidBody& add_coin(AnyScene& scene) {
  set_gravity(scene);
  scene.add_floor().setFriction(1);
  auto& disc = scene.template shape<btCylinderShapeZ>(vector(0.06, 0.06, 0.025));
  const auto mass = btScalar(0.5655);
  btVector3 inertia_B;
  disc.calculateLocalInertia(mass, inertia_B);
  const btTransform pose(btQuaternion(btVector3(1, 0, 0), btScalar(0.3)), vector(0, 0, 0.06));
  btRigidBody& coin = scene.add(mass, inertia_B, pose, disc);
  coin.setAngularVelocity(btVector3(0, 0, 20));
  coin.setFriction(1);
  return coin;
}

/// A solid ellipsoid with semi-axes 0.5, 0.4 and 0.25 m, about to roll on a rough floor.
template <class AnyScene>
btRigidBody& add_ellipsoid(AnyScene& scene) {
  set_gravity(scene);
  scene.add_floor().setFriction(1);
  auto& hull = scene.template shape<btConvexHullShape>();
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const double azimuth = 2 * M_PI * i / 40, height = M_PI * j / 20;
      hull.addPoint(vector(0.5 * std::sin(height) * std::cos(azimuth),
                           0.4 * std::sin(height) * std::sin(azimuth), 0.25 * std::cos(height)),
                    false);
    }
  }
  hull.recalcLocalAabb();
  btRigidBody& body =
      scene.add(1, vector(0.0445, 0.0625, 0.082),
                btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.1)), vector(0, 0, 0.27)), hull);
  body.setAngularVelocity(btVector3(6, 1, 5));
  body.setFriction(1);
  return body;
}

/// A chain of boxes, hung from the world by point joints, all turning.
template <class AnyScene>
void add_chain(AnyScene& scene, int count) {
  set_gravity(scene);
  const btVector3 ahead = vector(0.2, 0, 0);
  btRigidBody* last = nullptr;
  for (int i = 0; i < count; ++i) {
    btRigidBody& box = scene.add_box(vector(0.2, 0.1, 0.05), 1,
                                     btTransform(btQuaternion::getIdentity(), vector(0.2 + 0.4 * i, 0, 0)));
    box.setAngularVelocity(btVector3(0, 5, 1));
    if (last == nullptr) {
      scene.template join<btPoint2PointConstraint>(box, -ahead);
    } else {
      scene.template join<btPoint2PointConstraint>(*last, box, ahead, -ahead);
    }
    last = &box;
  }
}

/// Eight boxes of random shape that fall, spinning, onto each other; the first body is the floor.
template <class AnyScene>
void add_random_drop(AnyScene& scene, double spin, std::mt19937& random) {
  const auto uniform = [&](double low, double high) { return testing::uniform(random, low, high); };
  const auto direction = [&] {
    const double x = uniform(-1, 1), y = uniform(-1, 1);
    return vector(x, y, uniform(0.1, 1)).normalized();
  };
  set_gravity(scene);
  scene.add_floor().setFriction(btScalar(0.7));
  for (int i = 0; i < 8; ++i) {
    const double x = uniform(0.1, 0.6), y = uniform(0.05, 0.35), z = uniform(0.05, 0.15);
    const btQuaternion q_WB(direction(), btScalar(uniform(0, 3)));
    const double right = uniform(0, 1.5), ahead = uniform(0, 1.5);
    btRigidBody& box = scene.add_box(vector(x, y, z), btScalar(uniform(0.5, 1.5)),
                                     btTransform(q_WB, vector(right, ahead, 0.8 + 0.9 * i)));
    box.setAngularVelocity(direction() * btScalar(spin));
    box.setFriction(btScalar(0.7));
    box.forceActivationState(ACTIVE_TAG);
  }
}

/// Returns the kinetic and potential energy of all movable bodies.
template <class AnyScene>
double total_energy(const AnyScene& scene, double gravity = 0) {
  double sum = 0;
  for (const auto& body : scene.bodies()) {
    if (body->getInvMass() != 0) sum += energy_of(*body, gravity);
  }
  return sum;
}

}  // namespace polhode::testing
