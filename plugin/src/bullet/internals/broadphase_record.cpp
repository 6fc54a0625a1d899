#include "bullet/internals/broadphase_record.h"

#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <functional>
#include <new>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr int kNodeAlignment = 16;  // as in Bullet
constexpr std::int32_t kStageAtRest = btDbvtBroadphase::STAGECOUNT;

btDbvtProxy* proxy_of(const btCollisionObject& object) {
  return static_cast<btDbvtProxy*>(const_cast<btBroadphaseProxy*>(object.getBroadphaseHandle()));
}

std::int32_t object_of(const btDbvtProxy& proxy) {
  return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getWorldArrayIndex();
}

// Returns the inner nodes and the spare nodes of both trees, sorted by address.
std::vector<btDbvtNode*> inner_nodes(const btDbvtBroadphase& broadphase) {
  std::vector<btDbvtNode*> nodes;
  for (const btDbvt& tree : broadphase.m_sets) {
    if (tree.m_free != nullptr) nodes.push_back(tree.m_free);
    std::vector<btDbvtNode*> open;
    if (tree.m_root != nullptr) open.push_back(tree.m_root);
    while (!open.empty()) {
      btDbvtNode* const node = open.back();
      open.pop_back();
      if (node->isleaf()) continue;
      nodes.push_back(node);
      open.insert(open.end(), {node->childs[0], node->childs[1]});
    }
  }
  std::sort(nodes.begin(), nodes.end(), std::less<>());
  return nodes;
}

std::uint32_t rank_of(btDbvtNode* node, const std::vector<btDbvtNode*>& nodes) {
  return static_cast<std::uint32_t>(std::lower_bound(nodes.begin(), nodes.end(), node, std::less<>()) -
                                    nodes.begin());
}

TreeRecord record_of(const btDbvt& tree, const std::vector<btDbvtNode*>& nodes) {
  TreeRecord record;
  record.look_ahead = tree.m_lkhd;
  record.path = tree.m_opath;
  if (tree.m_free != nullptr) record.spare_ranks = {rank_of(tree.m_free, nodes)};
  std::vector<btDbvtNode*> open;
  if (tree.m_root != nullptr) open.push_back(tree.m_root);
  while (!open.empty()) {
    btDbvtNode* const node = open.back();
    open.pop_back();
    const bool is_leaf = node->isleaf();
    record.nodes.push_back(
        {is_leaf ? object_of(*static_cast<btDbvtProxy*>(node->data)) : NodeRecord::kInternal,
         node->volume.Mins(), node->volume.Maxs(), is_leaf ? 0 : rank_of(node, nodes)});
    if (!is_leaf) open.insert(open.end(), {node->childs[1], node->childs[0]});
  }
  return record;
}

// Returns true if the list contains each of 0 to count - 1 once.
template <class Number>
bool are_all(std::vector<Number> numbers, std::size_t count) {
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != static_cast<Number>(i)) return false;
  }
  return numbers.size() == count;
}

bool is_whole(const TreeRecord& tree) {
  if (tree.nodes.empty()) return true;
  std::size_t missing = 1;
  for (const NodeRecord& node : tree.nodes) {
    if (missing == 0) return false;
    node.object == NodeRecord::kInternal ? ++missing : --missing;
  }
  return missing == 0;
}

// Allocates or frees inner nodes to reach the given count, and returns them by the rank of their addresses.
class Nodes {
 public:
  Nodes(btDbvtBroadphase& broadphase, std::size_t count) : nodes_(inner_nodes(broadphase)) {
    while (nodes_.size() > count) {
      btAlignedFree(nodes_.back());
      nodes_.pop_back();
    }
    while (nodes_.size() < count)
      nodes_.push_back(new (btAlignedAlloc(sizeof(btDbvtNode), kNodeAlignment)) btDbvtNode());
    std::sort(nodes_.begin(), nodes_.end(), std::less<>());
  }
  btDbvtNode* at(std::uint32_t rank) const { return nodes_[rank]; }

 private:
  std::vector<btDbvtNode*> nodes_;
};

void write_tree(const TreeRecord& record, const btCollisionObjectArray& objects, const Nodes& nodes,
                btDbvt& tree) {
  tree.m_root = nullptr;
  tree.m_free = record.spare_ranks.empty() ? nullptr : nodes.at(record.spare_ranks[0]);
  tree.m_lkhd = record.look_ahead;
  tree.m_opath = record.path;
  tree.m_leaves = static_cast<int>((record.nodes.size() + 1) / 2);
  struct Open {
    btDbvtNode* parent;
    int child;
  };
  std::vector<Open> open = {{nullptr, 0}};
  for (const NodeRecord& from : record.nodes) {
    const Open place = open.back();
    open.pop_back();
    const bool is_leaf = from.object != NodeRecord::kInternal;
    btDbvtNode* const node = is_leaf ? proxy_of(*objects[from.object])->leaf : nodes.at(from.address_rank);
    node->volume = btDbvtVolume::FromMM(from.aabb_min, from.aabb_max);
    node->parent = place.parent;
    (place.parent == nullptr ? tree.m_root : place.parent->childs[place.child]) = node;
    if (is_leaf) {
      node->childs[1] = nullptr;
      node->data = proxy_of(*objects[from.object]);
    } else {
      open.insert(open.end(), {{node, 1}, {node, 0}});
    }
  }
}

void write_stage(const std::vector<std::int32_t>& stage, const btCollisionObjectArray& objects,
                 btDbvtProxy*& root) {
  root = nullptr;
  btDbvtProxy* last = nullptr;
  for (const std::int32_t object : stage) {
    btDbvtProxy* const proxy = proxy_of(*objects[object]);
    proxy->links[0] = last;
    proxy->links[1] = nullptr;
    (last == nullptr ? root : last->links[1]) = proxy;
    last = proxy;
  }
}

}  // namespace

BroadphaseRecord record_of(const btDbvtBroadphase& broadphase, const btCollisionObjectArray& objects) {
  BroadphaseRecord record;
  for (int i = 0; i < objects.size(); ++i) {
    const btDbvtProxy& proxy = *proxy_of(*objects[i]);
    record.proxies.push_back({proxy.m_uniqueId, proxy.m_aabbMin, proxy.m_aabbMax, proxy.stage});
  }
  const std::vector<btDbvtNode*> nodes = inner_nodes(broadphase);
  for (std::size_t i = 0; i < record.trees.size(); ++i)
    record.trees[i] = record_of(broadphase.m_sets[i], nodes);
  for (std::size_t i = 0; i < kStages; ++i) {
    for (const btDbvtProxy* proxy = broadphase.m_stageRoots[i]; proxy != nullptr; proxy = proxy->links[1])
      record.stages[i].push_back(object_of(*proxy));
  }
  record.current_stage = broadphase.m_stageCurrent;
  record.fixed_left = broadphase.m_fixedleft;
  record.new_pairs = broadphase.m_newpairs;
  record.cleanup_index = broadphase.m_cid;
  record.last_unique_id = broadphase.m_gid;
  record.needs_cleanup = broadphase.m_needcleanup;
  return record;
}

bool is_consistent(const BroadphaseRecord& record, std::size_t objects) {
  std::vector<std::int32_t> in_lists;
  std::vector<std::int32_t> in_trees;
  std::vector<std::uint32_t> ranks;
  const auto is_object = [objects](std::int32_t object) {
    return object >= 0 && static_cast<std::size_t>(object) < objects;
  };
  if (record.proxies.size() != objects) return false;
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    for (const std::int32_t object : record.stages[stage]) {
      if (!is_object(object) ||
          record.proxies[static_cast<std::size_t>(object)].stage != static_cast<int>(stage))
        return false;
      in_lists.push_back(object);
    }
  }
  for (std::size_t i = 0; i < record.trees.size(); ++i) {
    const TreeRecord& tree = record.trees[i];
    if (!is_whole(tree) || tree.spare_ranks.size() > 1) return false;
    ranks.insert(ranks.end(), tree.spare_ranks.begin(), tree.spare_ranks.end());
    for (const NodeRecord& node : tree.nodes) {
      if (node.object == NodeRecord::kInternal) {
        ranks.push_back(node.address_rank);
        continue;
      }
      if (!is_object(node.object)) return false;
      const bool is_at_rest = record.proxies[static_cast<std::size_t>(node.object)].stage == kStageAtRest;
      if (is_at_rest != (i == btDbvtBroadphase::FIXED_SET)) return false;
      in_trees.push_back(node.object);
    }
  }
  std::vector<std::int32_t> ids;
  for (const ProxyRecord& proxy : record.proxies) ids.push_back(proxy.unique_id);
  std::sort(ids.begin(), ids.end());
  const bool are_ids_unique = std::adjacent_find(ids.begin(), ids.end()) == ids.end() &&
                              (ids.empty() || (ids.front() > 0 && ids.back() <= record.last_unique_id));
  const std::size_t rank_count = ranks.size();
  return are_ids_unique && are_all(in_lists, objects) && are_all(in_trees, objects) &&
         are_all(std::move(ranks), rank_count) && record.current_stage >= 0 &&
         record.current_stage < kStageAtRest && record.new_pairs >= 0 && record.fixed_left >= 0 &&
         record.cleanup_index >= 0;
}

void write_to(const BroadphaseRecord& record, const btCollisionObjectArray& objects,
              btDbvtBroadphase& broadphase) {
  std::size_t inner = 0;
  for (const TreeRecord& tree : record.trees) inner += tree.nodes.size() / 2 + tree.spare_ranks.size();
  const Nodes nodes(broadphase, inner);
  for (std::size_t i = 0; i < record.trees.size(); ++i)
    write_tree(record.trees[i], objects, nodes, broadphase.m_sets[i]);
  for (int i = 0; i < objects.size(); ++i) {
    btDbvtProxy& proxy = *proxy_of(*objects[i]);
    const ProxyRecord& from = record.proxies[static_cast<std::size_t>(i)];
    proxy.m_uniqueId = from.unique_id;
    proxy.m_aabbMin = from.aabb_min;
    proxy.m_aabbMax = from.aabb_max;
    proxy.stage = from.stage;
  }
  for (std::size_t i = 0; i < kStages; ++i)
    write_stage(record.stages[i], objects, broadphase.m_stageRoots[i]);
  broadphase.m_stageCurrent = record.current_stage;
  broadphase.m_fixedleft = record.fixed_left;
  broadphase.m_newpairs = record.new_pairs;
  broadphase.m_cid = record.cleanup_index;
  broadphase.m_gid = record.last_unique_id;
  broadphase.m_needcleanup = record.needs_cleanup;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
