#pragma once

#include <LinearMath/btTransform.h>

#include "lanes/lane_rows.h"
#include "polhode/bullet/precision.h"

/// Eight of Bullet's vectors and matrices, in its precision, in lanes.
namespace polhode {
inline namespace POLHODE_PRECISION {

using BulletLanes = BasicLanes<RegistersOf<btScalar>>;
using BulletMask = BulletLanes::Mask;
using BulletDifferences = BasicLaneDifferences<RegistersOf<btScalar>>;
using BulletRows = LaneRows<btScalar>;

/// The rows of a matrix.
struct LaneBasis {
  BulletRows x, y, z;
};

/// `vector_of(lane)` is a btVector3.
template <class VectorOf>
POLHODE_INLINE BulletRows load_vectors(VectorOf vector_of) {
  return load_rows<btScalar>([&](std::size_t lane) { return vector_of(lane).m_floats; });
}

template <class VectorOf>
POLHODE_INLINE void store_vectors(const BulletRows& vectors, VectorOf vector_of) {
  store_rows(vectors, [&](std::size_t lane) { return vector_of(lane).m_floats; });
}

/// `basis_of(lane)` is a btMatrix3x3.
template <class BasisOf>
POLHODE_INLINE LaneBasis load_bases(BasisOf basis_of) {
  const auto row = [&](int i) {
    return load_vectors([&](std::size_t lane) -> auto& { return basis_of(lane)[i]; });
  };
  return {row(0), row(1), row(2)};
}

template <class BasisOf>
POLHODE_INLINE void store_bases(const LaneBasis& bases, BasisOf basis_of) {
  const auto store_row = [&](int i, const BulletRows& row) {
    store_vectors(
        row, [&](std::size_t lane) -> auto& { return basis_of(lane)[i]; });
  };
  store_row(0, bases.x);
  store_row(1, bases.y);
  store_row(2, bases.z);
}

/// `transform_of(lane)` is a btTransform, that is three rows of a matrix and a vector.
template <class TransformOf>
POLHODE_INLINE void store_transforms(const LaneBasis& bases, const BulletRows& origins,
                                     TransformOf transform_of) {
  static_assert(sizeof(btTransform) == 4 * sizeof(btVector3), "the vectors follow one another");
  const auto row_of = [&](int i) {
    return [&transform_of, i](std::size_t lane) { return transform_of(lane).getBasis()[i].m_floats; };
  };
  store_two_rows(bases.x, bases.y, row_of(0));
  store_two_rows(bases.z, origins, row_of(2));
}

/// As to_bullet rounds.
POLHODE_INLINE BulletRows to_bullet(const Vector3L& v) {
  return {BulletLanes::converted(v[0]), BulletLanes::converted(v[1]), BulletLanes::converted(v[2])};
}

POLHODE_INLINE LaneBasis to_bullet(const Matrix3L& m) {
  const auto row = [&m](int i) { return to_bullet(Vector3L(m(i, 0), m(i, 1), m(i, 2))); };
  return {row(0), row(1), row(2)};
}

POLHODE_INLINE Vector3L to_double(const BulletRows& v) {
  return {Lanes::converted(v.x), Lanes::converted(v.y), Lanes::converted(v.z)};
}

POLHODE_INLINE void add_differences(const BulletRows& a, const BulletRows& b, BulletDifferences& result) {
  result.add(a.x, b.x);
  result.add(a.y, b.y);
  result.add(a.z, b.z);
}

POLHODE_INLINE void add_differences(const LaneBasis& a, const LaneBasis& b, BulletDifferences& result) {
  add_differences(a.x, b.x, result);
  add_differences(a.y, b.y, result);
  add_differences(a.z, b.z, result);
}

/// btRigidBody::updateInertiaTensor of Bullet 3.24, without its SSE paths: basis.scaled(inverse inertia)
/// times the transposed basis, operation by operation in the same order.
POLHODE_INLINE LaneBasis inverse_inertia_tensor_W(const LaneBasis& basis,
                                                  const BulletRows& inverse_inertia_B) {
  const auto scaled = [&](const BulletRows& row) {
    return BulletRows{row.x * inverse_inertia_B.x, row.y * inverse_inertia_B.y, row.z * inverse_inertia_B.z};
  };
  const auto dot = [](const BulletRows& column, const BulletRows& row) {
    return column.x * row.x + column.y * row.y + column.z * row.z;
  };
  const auto row_of = [&](const BulletRows& row) {
    const BulletRows s = scaled(row);
    return BulletRows{dot(basis.x, s), dot(basis.y, s), dot(basis.z, s)};
  };
  return {row_of(basis.x), row_of(basis.y), row_of(basis.z)};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
