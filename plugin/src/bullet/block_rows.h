#pragma once

#include <array>

#include "bullet/body_block.h"
#include "bullet/bullet_lanes.h"
#include "bullet/managed_body.h"

/// The numbers of the bodies of a block, Bullet's and the library's, in lanes.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// The bodies of a block and what the library knows of them.
struct BlockRows {
  std::array<btRigidBody*, kLanes> bodies;
  std::array<BodyNumbers*, kLanes> numbers;

  explicit BlockRows(const BodyBlock& block) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      bodies[lane] = block.bodies[lane]->address();
      numbers[lane] = &block.bodies[lane]->numbers();
    }
  }

  /// `get(body)` is a btVector3 of Bullet's.
  template <class Get>
  POLHODE_INLINE BulletRows load(Get get) const {
    return load_vectors([&](std::size_t lane) -> auto& { return get(*bodies[lane]); });
  }
  template <class Get>
  POLHODE_INLINE void store(const BulletRows& vectors, Get get) const {
    store_vectors(
        vectors, [&](std::size_t lane) -> auto& { return get(*bodies[lane]); });
  }

  /// Behind three numbers there is another member.
  POLHODE_INLINE BulletRows load(PackedVector BodyNumbers::*member) const {
    return load_rows<btScalar>([&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE void store(const BulletRows& vectors, PackedVector BodyNumbers::*member) const {
    store_rows_of_three(vectors, [&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE Vector3L load(Vector3 BodyNumbers::*member) const {
    const auto rows = load_rows<double>([&](std::size_t lane) { return (numbers[lane]->*member).data(); });
    return {rows.x, rows.y, rows.z};
  }
  POLHODE_INLINE void store(const Vector3L& v, Vector3 BodyNumbers::*member) const {
    store_rows_of_three(LaneRows<double>{v[0], v[1], v[2]},
                        [&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE QuaternionL load_q_WB() const {
    const auto rows =
        load_rows_of_four<double>([&](std::size_t lane) { return numbers[lane]->q_WB.coeffs().data(); });
    return {rows.w, rows.x, rows.y, rows.z};
  }
  POLHODE_INLINE void store_q_WB(const QuaternionL& q) const {
    store_rows_of_four(LaneRowsOfFour<double>{q.x(), q.y(), q.z(), q.w()},
                       [&](std::size_t lane) { return numbers[lane]->q_WB.coeffs().data(); });
  }
};

inline btVector3& origin_of(btRigidBody& body) {
  return body.getWorldTransform().getOrigin();
}

inline btMatrix3x3& world_basis_of(btRigidBody& body) {
  return body.getWorldTransform().getBasis();
}

inline btVector3& interpolated_origin_of(btRigidBody& body) {
  return body.getInterpolationWorldTransform().getOrigin();
}

inline btMatrix3x3& interpolated_basis_of(btRigidBody& body) {
  return body.getInterpolationWorldTransform().getBasis();
}

inline LaneBasis load_world_bases(const BlockRows& block) {
  return load_bases([&](std::size_t lane) -> auto& { return world_basis_of(*block.bodies[lane]); });
}

/// To write to as well, which Bullet lets one do by setters only, one body at a time.
inline btVector3& omega_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getAngularVelocity());
}

inline btVector3& interpolated_velocity_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationLinearVelocity());
}

inline btVector3& interpolated_omega_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationAngularVelocity());
}

inline BulletRows load_omega_W(const BlockRows& block) {
  return block.load(omega_of);
}

inline BulletRows load_inverse_inertia_B(const BlockRows& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getInvInertiaDiagLocal(); });
}

inline BulletRows load_force_W(const BlockRows& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getTotalForce(); });
}

inline BulletRows load_torque_W(const BlockRows& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getTotalTorque(); });
}

inline BulletRows load_linear_velocity(const BlockRows& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getLinearVelocity(); });
}

inline BulletLanes sum(const BulletRows& v) {
  return v.x + v.y + v.z;
}

/// By a sum, which may also say no of huge numbers.
template <class... Rows>
inline BulletMask are_surely_finite(const Rows&... rows) {
  return (sum(rows) + ...) * btScalar(0.0) == btScalar(0.0);
}

inline BulletRows moved(const BulletRows& origin, const BulletRows& velocity, btScalar dt) {
  return {origin.x + velocity.x * dt, origin.y + velocity.y * dt, origin.z + velocity.z * dt};
}

inline BulletRows same_in_all(btScalar number) {
  return {number, number, number};
}

/// Free to turn about all axes, and no torque acts.
inline BulletMask turn_freely(const BlockRows& block, const BulletRows& inverse_inertia_B,
                              const BulletRows& torque_W) {
  BulletDifferences differences;
  add_differences(torque_W, same_in_all(0), differences);
  add_differences(block.load([](btRigidBody & body) -> auto& { return body.getAngularFactor(); }),
                  same_in_all(1), differences);
  const BulletLanes least = min(min(inverse_inertia_B.x, inverse_inertia_B.y), inverse_inertia_B.z);
  return differences.are_none() & (least > btScalar(0.0));
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
