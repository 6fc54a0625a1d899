#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstdint>
#include <vector>

#include "bullet/internals/pair_manifolds.h"
#include "polhode/bullet/precision.h"

/// The contacts that Bullet keeps from one step to the next: the overlapping pairs, their manifolds with
/// contact points and warm starting impulses, and the order of both, which the solver depends on. Objects are
/// identified by their index in the world's list.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Serializes a contact point without its user data, which is a pointer.
template <class Archive>
void serialize(Archive& archive, btManifoldPoint& point) {
  archive(point.m_localPointA, point.m_localPointB, point.m_positionWorldOnB, point.m_positionWorldOnA,
          point.m_normalWorldOnB, point.m_distance1, point.m_combinedFriction,
          point.m_combinedRollingFriction, point.m_combinedSpinningFriction, point.m_combinedRestitution,
          point.m_partId0, point.m_partId1, point.m_index0, point.m_index1, point.m_contactPointFlags,
          point.m_appliedImpulse, point.m_prevRHS, point.m_appliedImpulseLateral1,
          point.m_appliedImpulseLateral2, point.m_contactMotion1, point.m_contactMotion2, point.m_contactCFM,
          point.m_contactERP, point.m_frictionCFM, point.m_lifeTime, point.m_lateralFrictionDir1,
          point.m_lateralFrictionDir2);
}

struct ManifoldRecord {
  ManifoldPath path;
  std::int32_t place = 0;  ///< index in the dispatcher's list
  std::vector<btManifoldPoint> points;
};

template <class Archive>
void serialize(Archive& archive, ManifoldRecord& record) {
  archive(record.path, record.place, record.points);
}

struct PairRecord {
  std::int32_t object0 = 0;
  std::int32_t object1 = 0;
  bool has_algorithm = false;  ///< false if the pair was never awake, or its bodies do not collide
  std::vector<ManifoldRecord> manifolds;
};

template <class Archive>
void serialize(Archive& archive, PairRecord& record) {
  archive(record.object0, record.object1, record.has_algorithm, record.manifolds);
}

/// A manifold of the last step's predictive contacts. It has no effect any more, but occupies a place in the
/// list.
struct PredictiveRecord {
  std::int32_t object0 = 0;
  std::int32_t object1 = 0;
  std::int32_t place = 0;
};

template <class Archive>
void serialize(Archive& archive, PredictiveRecord& record) {
  archive(record.object0, record.object1, record.place);
}

struct ContactRecord {
  std::vector<PairRecord> pairs;
  std::vector<PredictiveRecord> predictive;
};

template <class Archive>
void serialize(Archive& archive, ContactRecord& record) {
  archive(record.pairs, record.predictive);
}

ContactRecord record_of_contacts(btDiscreteDynamicsWorld& world);

/// Returns true if the record is consistent for this number of objects.
bool is_consistent(const ContactRecord& record, std::size_t objects);

/// Restores contacts in two parts, between which the broadphase may be restored. The constructor removes all
/// pairs from the pair cache; finish() adds those of the record.
class ContactRestoration {
 public:
  explicit ContactRestoration(btDiscreteDynamicsWorld& world);
  ~ContactRestoration();
  ContactRestoration(const ContactRestoration&) = delete;
  ContactRestoration& operator=(const ContactRestoration&) = delete;

  /// Requires restored poses and broadphase ids, and a consistent record.
  void finish(const ContactRecord& record);

 private:
  void put_pair(const PairRecord& record);
  void put_manifolds(const PairRecord& record, btBroadphasePair& pair);
  void drop_former();
  void replace_predictive(const std::vector<PredictiveRecord>& records);
  void sort_manifolds();
  btCollisionAlgorithm* take_algorithm(const btBroadphasePair& pair);

  struct Placed {
    btPersistentManifold* manifold;
    std::int32_t place;
  };

  btDiscreteDynamicsWorld& world_;
  btCollisionDispatcher& dispatcher_;
  std::vector<btBroadphasePair> former_;  ///< sorted by the addresses of their proxies
  std::vector<Placed> placed_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
