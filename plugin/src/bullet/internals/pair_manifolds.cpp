#include "bullet/internals/pair_manifolds.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btHashedSimplePairCache.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <algorithm>

#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

using Wrapped = btCollisionObjectWrapper;

const btCompoundShape* compound_of(const Wrapped& wrapped) {
  const btCollisionShape& shape = *wrapped.getCollisionShape();
  return shape.isCompound() ? static_cast<const btCompoundShape*>(&shape) : nullptr;
}

// A child of a compound shape, wrapped as Bullet passes it to an algorithm.
class Child {
 public:
  Child(const Wrapped& parent, const btCompoundShape& compound, std::int32_t index)
      : pose_(parent.getWorldTransform() * compound.getChildTransform(index)),
        wrapped_(&parent, compound.getChildShape(index), parent.getCollisionObject(), pose_, -1, index) {}
  const Wrapped& wrapped() const { return wrapped_; }

 private:
  btTransform pose_;
  Wrapped wrapped_;
};

bool has_child(const btCompoundShape& compound, std::int32_t index) {
  return index >= 0 && index < compound.getNumChildShapes();
}

ManifoldPath extended(ManifoldPath path, std::initializer_list<std::int32_t> by) {
  path.insert(path.end(), by);
  return path;
}

btCollisionAlgorithm* algorithm_of(const btSimplePair& pair) {
  return static_cast<btCollisionAlgorithm*>(pair.m_userPointer);
}

void find_manifolds(btCollisionAlgorithm& algorithm, const ManifoldPath& path,
                    std::vector<PathedManifold>& result) {
  const CompoundParts parts = parts_of(algorithm);
  if (parts.children == nullptr) {
    btManifoldArray manifolds;
    algorithm.getAllContactManifolds(manifolds);
    for (int i = 0; i < manifolds.size(); ++i) result.push_back({extended(path, {i}), manifolds[i]});
    return;
  }
  for (int i = 0; i < parts.children->size(); ++i) {
    if ((*parts.children)[i] != nullptr) find_manifolds(*(*parts.children)[i], extended(path, {i}), result);
  }
  for (int i = 0; parts.pairs != nullptr && i < parts.pairs->getNumOverlappingPairs(); ++i) {
    const btSimplePair& pair = parts.pairs->getOverlappingPairArray()[i];
    find_manifolds(*algorithm_of(pair), extended(path, {pair.m_indexA, pair.m_indexB}), result);
  }
}

// Returns the wanted paths that contain `head` at `depth` and continue after it.
std::vector<ManifoldPath> below(const std::vector<ManifoldPath>& wanted, const ManifoldPath& head,
                                std::size_t depth) {
  std::vector<ManifoldPath> result;
  for (const ManifoldPath& path : wanted) {
    if (path.size() > depth + head.size() &&
        std::equal(head.begin(), head.end(), path.begin() + static_cast<std::ptrdiff_t>(depth)))
      result.push_back(path);
  }
  return result;
}

// Returns the distinct parts of the paths from `depth` on that name a child, each of this many numbers, in
// order.
std::vector<ManifoldPath> heads_of(const std::vector<ManifoldPath>& wanted, std::size_t depth,
                                   std::size_t numbers) {
  std::vector<ManifoldPath> heads;
  for (const ManifoldPath& path : wanted) {
    if (path.size() <= depth + numbers) continue;
    const auto first = path.begin() + static_cast<std::ptrdiff_t>(depth);
    ManifoldPath head(first, first + static_cast<std::ptrdiff_t>(numbers));
    if (std::find(heads.begin(), heads.end(), head) == heads.end()) heads.push_back(std::move(head));
  }
  return heads;
}

class ManifoldMaker {
 public:
  ManifoldMaker(btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
      : dispatcher_(dispatcher), info_(info) {}

  btCollisionAlgorithm* make_algorithm(const Wrapped& first, const Wrapped& second) {
    return dispatcher_.findAlgorithm(&first, &second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  }

  void make(const std::vector<ManifoldPath>& wanted, std::size_t depth, const Wrapped& first,
            const Wrapped& second, btCollisionAlgorithm& algorithm) {
    const CompoundParts parts = parts_of(algorithm);
    const btCompoundShape* const compound0 = compound_of(first);
    const btCompoundShape* const compound1 = compound_of(second);
    if (parts.children == nullptr) {
      make_simple(wanted, first, second, algorithm);
    } else if (parts.pairs != nullptr && compound0->getDynamicAabbTree() && compound1->getDynamicAabbTree()) {
      make_pairs(wanted, depth, first, second, *parts.pairs);
    } else if (compound0 != nullptr) {
      make_children(wanted, depth, first, *compound0, second, *parts.children);
    } else if (compound1 != nullptr) {
      make_children(wanted, depth, second, *compound1, first, *parts.children);
    }
  }

 private:
  // Runs the algorithm if manifolds are missing, since some algorithms create their manifold in their first
  // run.
  void make_simple(const std::vector<ManifoldPath>& wanted, const Wrapped& first, const Wrapped& second,
                   btCollisionAlgorithm& algorithm) {
    btManifoldArray manifolds;
    algorithm.getAllContactManifolds(manifolds);
    if (static_cast<std::size_t>(manifolds.size()) >= wanted.size()) return;
    btManifoldResult result(&first, &second);
    algorithm.processCollision(&first, &second, info_, &result);
  }

  void make_children(const std::vector<ManifoldPath>& wanted, std::size_t depth, const Wrapped& parent,
                     const btCompoundShape& compound, const Wrapped& other,
                     btAlignedObjectArray<btCollisionAlgorithm*>& children) {
    for (int i = 0; i < children.size() && has_child(compound, i); ++i) {
      const std::vector<ManifoldPath> of_child = below(wanted, {i}, depth);
      if (of_child.empty()) {
        if (children[i] != nullptr && !manifolds_of(*children[i]).empty()) {
          drop(children[i], dispatcher_);
          children[i] = nullptr;
        }
        continue;
      }
      const Child child(parent, compound, i);
      if (children[i] == nullptr) children[i] = make_algorithm(child.wrapped(), other);
      make(of_child, depth + 1, child.wrapped(), other, *children[i]);
    }
  }

  void make_pairs(const std::vector<ManifoldPath>& wanted, std::size_t depth, const Wrapped& first,
                  const Wrapped& second, btHashedSimplePairCache& pairs) {
    std::vector<btSimplePair> former;
    for (int i = 0; i < pairs.GetCount(); ++i) former.push_back(pairs.getOverlappingPairArray()[i]);
    pairs.removeAllPairs();
    std::vector<ManifoldPath> heads = heads_of(wanted, depth, 2);
    const auto is_gone = [&](const ManifoldPath& head) {
      return !has_child(*compound_of(first), head[0]) || !has_child(*compound_of(second), head[1]);
    };
    heads.erase(std::remove_if(heads.begin(), heads.end(), is_gone), heads.end());
    for (const ManifoldPath& head : heads) {
      const Child child0(first, *compound_of(first), head[0]);
      const Child child1(second, *compound_of(second), head[1]);
      btCollisionAlgorithm* algorithm = find(former, head);
      if (algorithm == nullptr) algorithm = make_algorithm(child0.wrapped(), child1.wrapped());
      pairs.addOverlappingPair(head[0], head[1])->m_userPointer = algorithm;
      make(below(wanted, head, depth), depth + 2, child0.wrapped(), child1.wrapped(), *algorithm);
    }
    for (const btSimplePair& pair : former) {
      const ManifoldPath head = {pair.m_indexA, pair.m_indexB};
      if (std::find(heads.begin(), heads.end(), head) == heads.end()) drop(algorithm_of(pair), dispatcher_);
    }
  }

  static btCollisionAlgorithm* find(const std::vector<btSimplePair>& pairs, const ManifoldPath& head) {
    for (const btSimplePair& pair : pairs) {
      if (pair.m_indexA == head[0] && pair.m_indexB == head[1]) return algorithm_of(pair);
    }
    return nullptr;
  }

  btCollisionDispatcher& dispatcher_;
  const btDispatcherInfo& info_;
};

// Wakes an object temporarily: for a sleeping pair Bullet creates no algorithm, or one without a manifold.
class Awake {
 public:
  explicit Awake(btCollisionObject& object) : object_(object), state_(object.getActivationState()) {
    object.forceActivationState(ACTIVE_TAG);
  }
  ~Awake() { object_.forceActivationState(state_); }
  Awake(const Awake&) = delete;
  Awake& operator=(const Awake&) = delete;

 private:
  btCollisionObject& object_;
  int state_;
};

}  // namespace

std::vector<PathedManifold> manifolds_of(btCollisionAlgorithm& algorithm) {
  std::vector<PathedManifold> result;
  find_manifolds(algorithm, {}, result);
  return result;
}

void make_manifolds(const std::vector<ManifoldPath>& wanted, btBroadphasePair& pair,
                    btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  auto& object0 = *static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject);
  auto& object1 = *static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
  const Awake awake0(object0);
  const Awake awake1(object1);
  const Wrapped first(nullptr, object0.getCollisionShape(), &object0, object0.getWorldTransform(), -1, -1);
  const Wrapped second(nullptr, object1.getCollisionShape(), &object1, object1.getWorldTransform(), -1, -1);
  ManifoldMaker maker(dispatcher, info);
  if (pair.m_algorithm == nullptr) pair.m_algorithm = maker.make_algorithm(first, second);
  if (pair.m_algorithm != nullptr) maker.make(wanted, 0, first, second, *pair.m_algorithm);
}

void drop(btCollisionAlgorithm* algorithm, btCollisionDispatcher& dispatcher) {
  if (algorithm == nullptr) return;
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
