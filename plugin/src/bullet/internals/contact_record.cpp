#include "bullet/internals/contact_record.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btCollisionObject& object_of(const btBroadphaseProxy& proxy) {
  return *static_cast<btCollisionObject*>(proxy.m_clientObject);
}

ManifoldRecord record_of(const PathedManifold& pathed) {
  ManifoldRecord record;
  record.path = pathed.path;
  record.place = pathed.manifold->m_index1a;
  for (int i = 0; i < pathed.manifold->getNumContacts(); ++i)
    record.points.push_back(pathed.manifold->getContactPoint(i));
  return record;
}

void write_points(std::vector<btManifoldPoint> points, btPersistentManifold& manifold) {
  manifold.clearManifold();  // the application may free the user data of the former points
  manifold.setNumContacts(static_cast<int>(points.size()));
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = points[static_cast<std::size_t>(i)];
    point.m_userPersistentData = nullptr;
    manifold.getContactPoint(i) = point;
  }
}

// Disables the application's contact callbacks, which are meant for contacts of a step.
class MutedContactCallbacks {
 public:
  MutedContactCallbacks() { swap(); }
  ~MutedContactCallbacks() { swap(); }
  MutedContactCallbacks(const MutedContactCallbacks&) = delete;
  MutedContactCallbacks& operator=(const MutedContactCallbacks&) = delete;

 private:
  void swap() {
    std::swap(gContactAddedCallback, added_);
    std::swap(gContactProcessedCallback, processed_);
    std::swap(gContactStartedCallback, started_);
    std::swap(gContactEndedCallback, ended_);
  }

  ContactAddedCallback added_ = nullptr;
  ContactProcessedCallback processed_ = nullptr;
  ContactStartedCallback started_ = nullptr;
  ContactEndedCallback ended_ = nullptr;
};

bool is_before(const btBroadphasePair& a, const btBroadphasePair& b) {
  const std::less<> less;
  return a.m_pProxy0 != b.m_pProxy0 ? less(a.m_pProxy0, b.m_pProxy0) : less(a.m_pProxy1, b.m_pProxy1);
}

}  // namespace

ContactRecord record_of_contacts(btDiscreteDynamicsWorld& world) {
  ContactRecord record;
  const btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
  for (int i = 0; i < pairs.size(); ++i) {
    PairRecord pair;
    pair.object0 = object_of(*pairs[i].m_pProxy0).getWorldArrayIndex();
    pair.object1 = object_of(*pairs[i].m_pProxy1).getWorldArrayIndex();
    pair.has_algorithm = pairs[i].m_algorithm != nullptr;
    if (pair.has_algorithm) {
      for (const PathedManifold& pathed : manifolds_of(*pairs[i].m_algorithm))
        pair.manifolds.push_back(record_of(pathed));
    }
    record.pairs.push_back(std::move(pair));
  }
  const auto& predictive = predictive_manifolds(world);
  for (int i = 0; i < predictive.size(); ++i) {
    record.predictive.push_back({predictive[i]->getBody0()->getWorldArrayIndex(),
                                 predictive[i]->getBody1()->getWorldArrayIndex(), predictive[i]->m_index1a});
  }
  return record;
}

bool is_consistent(const ContactRecord& record, std::size_t objects) {
  const auto is_object = [objects](std::int32_t object) {
    return object >= 0 && static_cast<std::size_t>(object) < objects;
  };
  std::vector<std::pair<std::int32_t, std::int32_t>> seen;
  for (const PairRecord& pair : record.pairs) {
    if (!is_object(pair.object0) || !is_object(pair.object1) || pair.object0 == pair.object1) return false;
    seen.emplace_back(std::min(pair.object0, pair.object1), std::max(pair.object0, pair.object1));
    if (!pair.has_algorithm && !pair.manifolds.empty()) return false;
    for (const ManifoldRecord& manifold : pair.manifolds) {
      if (manifold.points.size() > MANIFOLD_CACHE_SIZE) return false;
    }
  }
  std::sort(seen.begin(), seen.end());
  if (std::adjacent_find(seen.begin(), seen.end()) != seen.end()) return false;
  return std::all_of(record.predictive.begin(), record.predictive.end(),
                     [&](const PredictiveRecord& predictive) {
                       return is_object(predictive.object0) && is_object(predictive.object1);
                     });
}

// Keeps the algorithms, which removing their pairs would free.
ContactRestoration::ContactRestoration(btDiscreteDynamicsWorld& world)
    : world_(world), dispatcher_(static_cast<btCollisionDispatcher&>(*world.getDispatcher())) {
  btOverlappingPairCache& cache = *world.getPairCache();
  btBroadphasePairArray& pairs = cache.getOverlappingPairArray();
  former_.reserve(static_cast<std::size_t>(pairs.size()));
  while (pairs.size() > 0) {
    btBroadphasePair& last = pairs[pairs.size() - 1];
    former_.push_back(last);
    last.m_algorithm = nullptr;
    cache.removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, &dispatcher_);
  }
  std::sort(former_.begin(), former_.end(), is_before);
}

// Frees algorithms that are left if memory ran out.
ContactRestoration::~ContactRestoration() {
  const MutedContactCallbacks muted;
  drop_former();
}

void ContactRestoration::drop_former() {
  for (btBroadphasePair& pair : former_) drop(std::exchange(pair.m_algorithm, nullptr), dispatcher_);
}

void ContactRestoration::finish(const ContactRecord& record) {
  const MutedContactCallbacks muted;
  for (const PairRecord& pair : record.pairs) put_pair(pair);
  drop_former();
  replace_predictive(record.predictive);
  sort_manifolds();
}

void ContactRestoration::put_pair(const PairRecord& record) {
  const btCollisionObjectArray& objects = world_.getCollisionObjectArray();
  btBroadphasePair* const pair = world_.getPairCache()->addOverlappingPair(
      objects[record.object0]->getBroadphaseHandle(), objects[record.object1]->getBroadphaseHandle());
  if (pair == nullptr) return;  // rejected by a collision filter that the application has set since
  btCollisionAlgorithm* const former = take_algorithm(*pair);
  if (record.has_algorithm) {
    pair->m_algorithm = former;
    put_manifolds(record, *pair);
  } else {
    drop(former, dispatcher_);
  }
}

void ContactRestoration::put_manifolds(const PairRecord& record, btBroadphasePair& pair) {
  std::vector<ManifoldPath> wanted;
  for (const ManifoldRecord& manifold : record.manifolds) wanted.push_back(manifold.path);
  make_manifolds(wanted, pair, dispatcher_, world_.getDispatchInfo());
  if (pair.m_algorithm == nullptr) return;
  for (const PathedManifold& pathed : manifolds_of(*pair.m_algorithm)) {
    const auto found = std::find(wanted.begin(), wanted.end(), pathed.path);
    if (found == wanted.end()) {
      pathed.manifold->clearManifold();
      continue;
    }
    const ManifoldRecord& manifold = record.manifolds[static_cast<std::size_t>(found - wanted.begin())];
    write_points(manifold.points, *pathed.manifold);
    placed_.push_back({pathed.manifold, manifold.place});
  }
}

// Returns null if the pair had no algorithm, or one for the two bodies in the other order.
btCollisionAlgorithm* ContactRestoration::take_algorithm(const btBroadphasePair& pair) {
  const auto found = std::lower_bound(former_.begin(), former_.end(), pair, is_before);
  if (found == former_.end() || is_before(pair, *found)) return nullptr;
  return std::exchange(found->m_algorithm, nullptr);
}

void ContactRestoration::replace_predictive(const std::vector<PredictiveRecord>& records) {
  auto& predictive = predictive_manifolds(world_);
  for (int i = 0; i < predictive.size(); ++i) dispatcher_.releaseManifold(predictive[i]);
  predictive.resize(0);
  const btCollisionObjectArray& objects = world_.getCollisionObjectArray();
  for (const PredictiveRecord& record : records) {
    btPersistentManifold* const manifold =
        dispatcher_.getNewManifold(objects[record.object0], objects[record.object1]);
    predictive.push_back(manifold);
    placed_.push_back({manifold, record.place});
  }
}

// Sorts manifolds without a position in the record to the end.
void ContactRestoration::sort_manifolds() {
  const int count = dispatcher_.getNumManifolds();
  btPersistentManifold** const manifolds = dispatcher_.getInternalManifoldPointer();
  std::vector<Placed> sorted;
  for (int i = 0; i < count; ++i) sorted.push_back({manifolds[i], INT32_MAX});
  for (const Placed& placed : placed_)
    sorted[static_cast<std::size_t>(placed.manifold->m_index1a)].place = placed.place;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Placed& a, const Placed& b) { return a.place < b.place; });
  for (int i = 0; i < count; ++i) {
    manifolds[i] = sorted[static_cast<std::size_t>(i)].manifold;
    manifolds[i]->m_index1a = i;
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
