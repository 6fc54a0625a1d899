#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <array>
#include <cstdint>
#include <vector>

#include "polhode/bullet/precision.h"

/// The internal state of a btDbvtBroadphase. The overlapping pairs and their order depend on its boxes, which
/// are larger than the bodies' and lag behind, and on its trees. Objects are identified by their index in the
/// world's list.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// The broadphase's data of an object.
struct ProxyRecord {
  std::int32_t unique_id = 0;
  btVector3 aabb_min = btVector3(0, 0, 0);
  btVector3 aabb_max = btVector3(0, 0, 0);
  std::int32_t stage = 0;  ///< the object's list; the last list holds the resting objects
};

template <class Archive>
void serialize(Archive& archive, ProxyRecord& record) {
  archive(record.unique_id, record.aabb_min, record.aabb_max, record.stage);
}

struct NodeRecord {
  static constexpr std::int32_t kInternal = -1;

  std::int32_t object = kInternal;
  btVector3 aabb_min = btVector3(0, 0, 0);
  btVector3 aabb_max = btVector3(0, 0, 0);
  /// For an internal node: the number of nodes of both trees with smaller addresses. Bullet balances a tree
  /// by comparing addresses.
  std::uint32_t address_rank = 0;
};

template <class Archive>
void serialize(Archive& archive, NodeRecord& record) {
  archive(record.object, record.aabb_min, record.aabb_max, record.address_rank);
}

struct TreeRecord {
  std::vector<NodeRecord> nodes;  ///< depth first: a parent, its first child's subtree, its second child's
  std::vector<std::uint32_t> spare_ranks;  ///< address rank of the tree's spare node, if it has one
  std::int32_t look_ahead = -1;
  std::uint32_t path = 0;
};

template <class Archive>
void serialize(Archive& archive, TreeRecord& record) {
  archive(record.nodes, record.spare_ranks, record.look_ahead, record.path);
}

inline constexpr std::size_t kStages = btDbvtBroadphase::STAGECOUNT + 1;

struct BroadphaseRecord {
  std::vector<ProxyRecord> proxies;  ///< by object
  std::array<TreeRecord, 2> trees;
  std::array<std::vector<std::int32_t>, kStages> stages;  ///< the objects of each list
  std::int32_t current_stage = 0;
  std::int32_t fixed_left = 0;
  std::int32_t new_pairs = 0;
  std::int32_t cleanup_index = 0;
  std::int32_t last_unique_id = 0;
  bool needs_cleanup = false;
};

template <class Archive>
void serialize(Archive& archive, BroadphaseRecord& record) {
  archive(record.proxies, record.trees, record.stages, record.current_stage, record.fixed_left,
          record.new_pairs, record.cleanup_index, record.last_unique_id, record.needs_cleanup);
}

BroadphaseRecord record_of(const btDbvtBroadphase& broadphase, const btCollisionObjectArray& objects);

/// Returns true if the record is consistent: each of this number of objects is in one list and in the
/// matching tree.
bool is_consistent(const BroadphaseRecord& record, std::size_t objects);

/// Requires a consistent record and an empty pair cache, which finds pairs by the unique ids that this
/// changes.
void write_to(const BroadphaseRecord& record, const btCollisionObjectArray& objects,
              btDbvtBroadphase& broadphase);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
