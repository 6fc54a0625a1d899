#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>

#include "bullet/internals/private_members.h"
#include "polhode/bullet/precision.h"
#include "scheme_base/wide_state.h"
#include "simd/gather.h"
#include "simd/lane_bits.h"

/// Gathers and scatters the vectors and matrices of eight Bullet bodies, in Bullet's precision.
namespace polhode {
inline namespace POLHODE_PRECISION {

using BulletWide = BasicWide<RegistersOf<btScalar>>;
using BulletMask = BulletWide::Mask;
using BulletDifferences = BasicWideDifferences<RegistersOf<btScalar>>;
using BulletRows = WideRows<btScalar>;

/// The body of each lane; never null.
using BodyPointers = std::array<btRigidBody*, kLanes>;

/// The rows of a matrix.
struct BulletBasis {
  BulletRows x, y, z;
};

/// @name Masks from bits
/// @{
template <class WideNumber>
POLHODE_INLINE typename WideNumber::Mask mask_of(const LaneBits& lanes) {
  using Number = typename WideNumber::Number;
  WideNumber ones = Number(0);
  for (std::size_t lane = 0; lane < kLanes; ++lane) ones.set(lane, lanes[lane] ? Number(1) : Number(0));
  return ones > Number(0);
}
POLHODE_INLINE WideMask wide_mask(const LaneBits& lanes) {
  return mask_of<Wide>(lanes);
}
POLHODE_INLINE BulletMask bullet_mask(const LaneBits& lanes) {
  return mask_of<BulletWide>(lanes);
}
POLHODE_INLINE BulletRows select(const BulletMask& mask, const BulletRows& a, const BulletRows& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
/// @}

/// @name Gather and scatter
/// `get(body)` returns a btVector3, btMatrix3x3 or btTransform of the body.
/// @{
template <class Get>
POLHODE_INLINE BulletRows gather(const BodyPointers& bodies, Get get) {
  return gather_rows<btScalar>([&](std::size_t lane) { return get(*bodies[lane]).m_floats; });
}

template <class Get>
POLHODE_INLINE void scatter(const BulletRows& vectors, const BodyPointers& bodies, Get get) {
  scatter_rows(vectors, [&](std::size_t lane) { return get(*bodies[lane]).m_floats; });
}

template <class Get>
POLHODE_INLINE BulletBasis gather_basis(const BodyPointers& bodies, Get get) {
  const auto row = [&](int i) {
    return gather_rows<btScalar>([&](std::size_t lane) { return get(*bodies[lane])[i].m_floats; });
  };
  return {row(0), row(1), row(2)};
}

template <class Get>
POLHODE_INLINE void scatter_basis(const BulletBasis& bases, const BodyPointers& bodies, Get get) {
  const auto scatter_row = [&](int i, const BulletRows& row) {
    scatter_rows(row, [&](std::size_t lane) { return get(*bodies[lane])[i].m_floats; });
  };
  scatter_row(0, bases.x);
  scatter_row(1, bases.y);
  scatter_row(2, bases.z);
}

template <class Get>
POLHODE_INLINE void scatter_transform(const BulletBasis& bases, const BulletRows& origins,
                                      const BodyPointers& bodies, Get get) {
  static_assert(sizeof(btTransform) == 4 * sizeof(btVector3), "the vectors follow one another");
  const auto row_of = [&](int i) {
    return [&bodies, &get, i](std::size_t lane) { return get(*bodies[lane]).getBasis()[i].m_floats; };
  };
  scatter_two_rows(bases.x, bases.y, row_of(0));
  scatter_two_rows(bases.z, origins, row_of(2));
}
/// @}

/// @name Members to gather and scatter
/// @{
inline btTransform& pose(btRigidBody& body) {
  return body.getWorldTransform();
}
inline btTransform& interpolation_pose(btRigidBody& body) {
  return body.getInterpolationWorldTransform();
}
inline btVector3& origin(btRigidBody& body) {
  return body.getWorldTransform().getOrigin();
}
inline btMatrix3x3& basis(btRigidBody& body) {
  return body.getWorldTransform().getBasis();
}
inline btVector3& inverse_inertia_B(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInvInertiaDiagLocal());
}
inline btVector3& linear_velocity(btRigidBody& body) {
  return const_cast<btVector3&>(body.getLinearVelocity());
}
inline btVector3& angular_factor(btRigidBody& body) {
  return const_cast<btVector3&>(body.getAngularFactor());
}
inline btVector3& total_force(btRigidBody& body) {
  return const_cast<btVector3&>(body.getTotalForce());
}
inline btVector3& total_torque(btRigidBody& body) {
  return const_cast<btVector3&>(body.getTotalTorque());
}
/// @}

/// @name Between Bullet's precision and double
/// Rounds like static_cast. Conversion to double is exact.
/// @{
POLHODE_INLINE BulletRows to_bullet(const Vector3Wide& v) {
  return {BulletWide::converted(v[0]), BulletWide::converted(v[1]), BulletWide::converted(v[2])};
}
POLHODE_INLINE BulletBasis to_bullet(const Matrix3Wide& m) {
  const auto row = [&m](int i) { return to_bullet(Vector3Wide(m(i, 0), m(i, 1), m(i, 2))); };
  return {row(0), row(1), row(2)};
}
POLHODE_INLINE Vector3Wide to_double(const BulletRows& v) {
  return {Wide::converted(v.x), Wide::converted(v.y), Wide::converted(v.z)};
}
/// @}

/// @name Bitwise comparison
/// @{
POLHODE_INLINE void add_differences(const BulletRows& a, const BulletRows& b, BulletDifferences& result) {
  result.add(a.x, b.x);
  result.add(a.y, b.y);
  result.add(a.z, b.z);
}
POLHODE_INLINE void add_differences(const BulletBasis& a, const BulletBasis& b, BulletDifferences& result) {
  add_differences(a.x, b.x, result);
  add_differences(a.y, b.y, result);
  add_differences(a.z, b.z, result);
}
/// @}

/// Checks all numbers at once. May return false for huge finite numbers.
template <class... Rows>
POLHODE_INLINE BulletMask are_surely_finite(const Rows&... rows) {
  return ((rows.x + rows.y + rows.z) + ...) * btScalar(0.0) == btScalar(0.0);
}

/// Returns I_W^-1 = R I_B^-1 R^T in Bullet's precision, with the formula of btRigidBody::updateInertiaTensor.
POLHODE_INLINE BulletBasis inverse_inertia_basis_W(const BulletBasis& basis,
                                                   const BulletRows& inverse_inertia_B) {
  const auto dot = [](const BulletRows& a, const BulletRows& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto row_of = [&](const BulletRows& row) {
    const BulletRows scaled = {row.x * inverse_inertia_B.x, row.y * inverse_inertia_B.y,
                               row.z * inverse_inertia_B.z};
    return BulletRows{dot(basis.x, scaled), dot(basis.y, scaled), dot(basis.z, scaled)};
  };
  return {row_of(basis.x), row_of(basis.y), row_of(basis.z)};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
