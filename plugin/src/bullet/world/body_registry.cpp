#include "bullet/world/body_registry.h"

#include <algorithm>
#include <functional>
#include <new>
#include <utility>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

template <class Element>
void reserve_one_more(std::vector<Element>& list) {
  if (list.size() == list.capacity()) list.reserve(2 * list.size() + 1);
}

}  // namespace

bool BodyRegistry::synchronize(const List& list, const SchemeChoices& choices) noexcept {
  const bool is_unchanged = std::equal(bodies_.begin(), bodies_.end(), list.first, list.first + list.size);
  if (is_unchanged && !lacks_memory_) return false;
  const std::size_t size_with_memory = reserve(list.size);
  lacks_memory_ = size_with_memory < list.size;
  if (!is_unchanged) follow({list.first, size_with_memory});
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].family == kPending) try_to_add(i, choices);
  }
  list_batches();
  ++changes_;
  return true;
}

// Allocates memory for a list of this size. Returns the size for which memory is available.
std::size_t BodyRegistry::reserve(std::size_t size) noexcept {
  const auto capacity = [this] {
    return std::min({bodies_.capacity(), places_.capacity(), moved_.capacity()});
  };
  if (size <= capacity()) return size;
  try {
    const std::size_t wanted = std::max(size, 2 * capacity());
    bodies_.reserve(wanted);
    places_.reserve(wanted);
    moved_.reserve(wanted);
  } catch (const std::bad_alloc&) {  // the rest of the list stays with Bullet for now
  }
  return std::min(size, capacity());
}

// Updates bodies_ to match the list. Requires memory from `reserve`.
void BodyRegistry::follow(const List& list) noexcept {
  // Bodies that left their position in the list: removed, or moved within the list.
  const std::size_t former_size = bodies_.size();
  moved_.clear();
  for (std::size_t i = 0; i < former_size; ++i) {
    const bool stays = i < list.size && bodies_[i] == list[i];
    if (!stays) moved_.push_back({bodies_[i], std::exchange(places_[i], Place())});
  }
  const auto by_address = [](const Moved& a, const Moved& b) {
    return std::less<const btRigidBody*>()(a.body, b.body);
  };
  std::sort(moved_.begin(), moved_.end(), by_address);
  bodies_.resize(list.size);
  places_.resize(list.size);
  for (std::size_t i = 0; i < list.size; ++i) {
    btRigidBody* body = list[i];
    if (i < former_size && bodies_[i] == body) continue;
    bodies_[i] = body;
    const auto found = std::lower_bound(moved_.begin(), moved_.end(), Moved{body, Place()}, by_address);
    if (found == moved_.end() || found->body != body) {
      places_[i] = {kPending, static_cast<std::uint32_t>(body_identity(*body))};
      continue;
    }
    places_[i] = std::exchange(found->place, Place());
    if (has_lane(places_[i])) {
      families_[places_[i].family].batch_of(places_[i].number).list_index[places_[i].number % kLanes] =
          static_cast<std::uint32_t>(i);
    }
  }
  // From the last to the first, so that a hole is filled by a body that stays.
  std::sort(moved_.begin(), moved_.end(),
            [](const Moved& a, const Moved& b) { return a.place.number > b.place.number; });
  for (const Moved& gone : moved_) remove(gone.place);
}

void BodyRegistry::try_to_add(std::size_t index, const SchemeChoices& choices) noexcept {
  const Treatment treatment = choices.treatment_of(*bodies_[index]);
  try {
    if (treatment.scheme != nullptr) reserve_lane(treatment);
    add(index, treatment);
  } catch (const std::bad_alloc&) {
    lacks_memory_ = true;
  }
}

// Reserves nothing if memory runs out.
template <class ReserveAll>
void BodyRegistry::reserve_all_or_none(const ReserveAll& reserve_all) {
  try {
    reserve_all();
  } catch (...) {
    list_batches();
    throw;
  }
}

bool BodyRegistry::has_other_treatment(std::size_t index, const Treatment& wanted) const {
  const Lane place = lane_at(index);
  if (is_replaced(index)) return true;
  if (place.batch == nullptr || wanted.scheme == nullptr)
    return (place.batch != nullptr) != (wanted.scheme != nullptr);
  return place.batch->scheme != wanted.scheme ||
         (place.batch->driven != nullptr) != (wanted.drive != nullptr);
}

void BodyRegistry::reserve_for_choices(const SchemeChoices& choices) {
  reserve_all_or_none([&] {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Treatment wanted = choices.treatment_of(*bodies_[i]);
      if (wanted.scheme != nullptr && has_other_treatment(i, wanted)) reserve_lane(wanted);
    }
  });
}

void BodyRegistry::adopt_choices(const SchemeChoices& choices) noexcept {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Treatment wanted = choices.treatment_of(*bodies_[i]);
    if (!has_other_treatment(i, wanted)) continue;
    remove(i);
    add(i, wanted);
  }
  list_batches();
}

void BodyRegistry::apply_choices(const SchemeChoices& choices) {
  reserve_for_choices(choices);
  adopt_choices(choices);
}

void BodyRegistry::restart(btRigidBody& body, const Treatment& treatment) {
  const std::size_t index = index_of(body);
  if (index == bodies_.size()) return;
  reserve_all_or_none([&] {
    if (treatment.scheme != nullptr) reserve_lane(treatment);
  });
  remove(index);
  add(index, treatment);
  list_batches();
}

void BodyRegistry::drive(btRigidBody& body, const Treatment& treatment) {
  const std::size_t index = index_of(body);
  if (index == bodies_.size()) return;
  const Lane before = lane_at(index);
  if (before.batch == nullptr || is_replaced(index)) {
    restart(body, treatment);
  } else if (!has_other_treatment(index, treatment)) {
    if (before.batch->driven != nullptr) before.batch->driven->drives[before.lane] = treatment.drive;
  } else {
    reserve_all_or_none([&] { reserve_lane(treatment); });
    const Place place_before = places_[index];
    add(index, treatment);
    const Lane after = lane_at(index);
    after.batch->move_from(*before.batch, before.lane, after.lane);
    remove(place_before);
    list_batches();
  }
}

void BodyRegistry::clear() {
  const std::uint64_t changes = changes_;
  *this = BodyRegistry();
  changes_ = changes + 1;
}

BodyRegistry::Lane BodyRegistry::lane_at(std::size_t index) const {
  const Place& place = places_[index];
  if (!has_lane(place)) return {nullptr, 0};
  return {families_[place.family].batches[place.number / kLanes].get(), place.number % kLanes};
}

BodyRegistry::Lane BodyRegistry::lane_at(std::size_t index, const btRigidBody& body) const {
  if (index >= bodies_.size() || bodies_[index] != &body) return {nullptr, 0};
  return lane_at(index);
}

bool BodyRegistry::is_replaced(std::size_t index) const {
  const Place& place = places_[index];
  const Lane lane = lane_at(index);
  const int seen = lane.batch != nullptr ? lane.batch->identities[lane.lane] : static_cast<int>(place.number);
  return seen != body_identity(*bodies_[index]);
}

bool BodyRegistry::has_replaced_bodies_left_to_bullet() const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].family == kNone && is_replaced(i)) return true;
  }
  return false;
}

BodyRegistry::Lane BodyRegistry::find(const btRigidBody& body, const SchemeChoices& choices) {
  const std::size_t index = index_of(body);
  if (index == bodies_.size()) return {nullptr, 0};
  if (is_replaced(index)) restart(*bodies_[index], choices.treatment_of(*bodies_[index]));
  return lane_at(index);
}

// Makes room for one more body.
void BodyRegistry::reserve_lane(const Treatment& treatment) {
  Family& family = families_[family_of(treatment)];
  if (family.count + family.reserved == family.batches.size() * kLanes) {
    reserve_one_more(batches_);
    reserve_one_more(family.batches);
    family.batches.push_back(std::make_unique<Batch>(family.scheme, family.is_driven));
    batches_.push_back(family.batches.back().get());
  }
  ++family.reserved;
}

// Requires a reserved lane. Leaves the body to Bullet if the scheme is null.
void BodyRegistry::add(std::size_t index, const Treatment& treatment) noexcept {
  btRigidBody& body = *bodies_[index];
  Place& place = places_[index];
  place = {kNone, static_cast<std::uint32_t>(body_identity(body))};
  if (treatment.scheme == nullptr) return;
  place.family = known_family(treatment);
  Family& family = families_[place.family];
  place.number = static_cast<std::uint32_t>(family.count);
  ++family.count;
  --family.reserved;
  Batch& batch = family.batch_of(place.number);
  batch.attach(place.number % kLanes, body, treatment.drive);
  batch.list_index[place.number % kLanes] = static_cast<std::uint32_t>(index);
}

// Keeps empty batches until list_batches.
void BodyRegistry::remove(const Place& place) noexcept {
  if (!has_lane(place)) return;
  Family& family = families_[place.family];
  const std::size_t last = family.count - 1;
  Batch& last_batch = family.batch_of(last);
  if (place.number != last) {
    Batch& batch = family.batch_of(place.number);
    batch.move_from(last_batch, last % kLanes, place.number % kLanes);
    places_[batch.list_index[place.number % kLanes]].number = place.number;
  }
  last_batch.detach(last % kLanes);
  --family.count;
}

// Returns kNone if there is no such family yet.
std::uint32_t BodyRegistry::known_family(const Treatment& treatment) const {
  const auto& families = family_of_scheme_[treatment.drive != nullptr ? 1 : 0];
  const auto known = families.find(treatment.scheme.get());
  return known == families.end() ? kNone : known->second;
}

std::uint32_t BodyRegistry::family_of(const Treatment& treatment) {
  const std::uint32_t known = known_family(treatment);
  if (known != kNone) return known;
  const auto unused = std::find_if(families_.begin(), families_.end(),
                                   [](const Family& family) { return family.scheme == nullptr; });
  const auto number = static_cast<std::uint32_t>(unused - families_.begin());
  if (unused == families_.end()) families_.emplace_back();
  const bool is_driven = treatment.drive != nullptr;
  families_[number].scheme = treatment.scheme;
  families_[number].is_driven = is_driven;
  family_of_scheme_[is_driven ? 1 : 0][treatment.scheme.get()] = number;
  return number;
}

// Returns bodies_.size() if the body is not in the list.
std::size_t BodyRegistry::index_of(const btRigidBody& body) const {
  if (body.getWorldArrayIndex() < 0) return bodies_.size();
  const auto hint = static_cast<std::size_t>(body.getWorldArrayIndex());
  if (hint < hints_.size() && hints_[hint] < bodies_.size() && bodies_[hints_[hint]] == &body)
    return hints_[hint];
  const auto found = std::find(bodies_.begin(), bodies_.end(), &body);
  if (found == bodies_.end()) return bodies_.size();
  if (hint >= hints_.size()) hints_.resize(hint + 1, kNone);
  hints_[hint] = static_cast<std::uint32_t>(found - bodies_.begin());
  return hints_[hint];
}

// Lists the batches that hold bodies and deletes the others.
void BodyRegistry::list_batches() noexcept {
  batches_.clear();
  for (Family& family : families_) {
    family.reserved = 0;
    family.batches.resize((family.count + kLanes - 1) / kLanes);
    for (const auto& batch : family.batches) batches_.push_back(batch.get());
    if (family.count > 0 || family.scheme == nullptr) continue;
    family_of_scheme_[family.is_driven ? 1 : 0].erase(family.scheme.get());
    family.scheme = nullptr;
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
