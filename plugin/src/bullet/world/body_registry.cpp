#include "bullet/world/body_registry.h"

#include <algorithm>
#include <utility>

namespace polhode {
inline namespace POLHODE_PRECISION {

bool BodyRegistry::synchronize(const Bodies& bodies, const SchemeChoices& choices) {
  const auto size = static_cast<std::size_t>(bodies.size());
  const std::size_t same = std::min(size, bodies_.size());
  const bool is_unchanged =
      size == bodies_.size() && (size == 0 || std::equal(bodies_.begin(), bodies_.end(), &bodies[0]));
  if (is_unchanged) return false;
  // Bodies that are not where they were: gone, or moved within the list.
  std::unordered_map<const btRigidBody*, Place> missing;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const bool stays = i < same && bodies_[i] == bodies[static_cast<int>(i)];
    if (!stays) missing.emplace(bodies_[i], std::exchange(places_[i], Place()));
  }
  const std::size_t former_size = bodies_.size();
  bodies_.resize(size);
  places_.resize(size);
  std::vector<std::size_t> arrived;
  for (std::size_t i = 0; i < size; ++i) {
    btRigidBody* body = bodies[static_cast<int>(i)];
    if (i < former_size && bodies_[i] == body) continue;
    bodies_[i] = body;
    const auto moved = missing.find(body);
    if (moved == missing.end()) {
      arrived.push_back(i);
      continue;
    }
    places_[i] = moved->second;
    if (places_[i].family != kNone) {
      families_[places_[i].family].batch_of(places_[i].number).list_index[places_[i].number % kLanes] =
          static_cast<std::uint32_t>(i);
    }
    missing.erase(moved);
  }
  // From the last to the first, so that the body that fills the hole is one that stays.
  std::vector<Place> gone;
  for (const auto& body_and_place : missing) gone.push_back(body_and_place.second);
  std::sort(gone.begin(), gone.end(), [](const Place& a, const Place& b) { return a.number > b.number; });
  for (const Place& place : gone) remove(place);
  for (const std::size_t index : arrived) add(index, choices);
  list_batches();
  return true;
}

void BodyRegistry::apply_choices(const SchemeChoices& choices) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Batch* batch = lane_at(i).batch;
    const SchemePointer wanted = choices.scheme_of(*bodies_[i]);
    if (!is_replaced(i) && (batch == nullptr ? nullptr : batch->scheme.get()) == wanted.get()) continue;
    remove(i);
    add(i, choices);
  }
  list_batches();
}

void BodyRegistry::restart(btRigidBody& body, const SchemeChoices& choices) {
  const std::size_t index = index_of(body);
  if (index == bodies_.size()) return;
  remove(index);
  add(index, choices);
  list_batches();
}

void BodyRegistry::clear() {
  *this = BodyRegistry();
}

BodyRegistry::Lane BodyRegistry::lane_at(std::size_t index) const {
  const Place& place = places_[index];
  if (place.family == kNone) return {nullptr, 0};
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
  if (is_replaced(index)) restart(*bodies_[index], choices);
  return lane_at(index);
}

void BodyRegistry::add(std::size_t index, const SchemeChoices& choices) {
  btRigidBody& body = *bodies_[index];
  const SchemePointer scheme = choices.scheme_of(body);
  Place& place = places_[index];
  place = {kNone, static_cast<std::uint32_t>(body_identity(body))};
  if (scheme == nullptr) return;
  place.family = family_of(scheme);
  Family& family = families_[place.family];
  place.number = static_cast<std::uint32_t>(family.count);
  if (family.count % kLanes == 0) family.batches.push_back(std::make_unique<Batch>(scheme));
  ++family.count;
  Batch& batch = family.batch_of(place.number);
  batch.attach(place.number % kLanes, body);
  batch.list_index[place.number % kLanes] = static_cast<std::uint32_t>(index);
}

void BodyRegistry::remove(const Place& place) {
  if (place.family == kNone) return;
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
  if (family.count % kLanes == 0) family.batches.pop_back();
  if (family.count > 0) return;
  family_of_scheme_.erase(family.scheme.get());
  family.scheme = nullptr;
}

std::uint32_t BodyRegistry::family_of(const SchemePointer& scheme) {
  const auto known = family_of_scheme_.find(scheme.get());
  if (known != family_of_scheme_.end()) return known->second;
  const auto unused = std::find_if(families_.begin(), families_.end(),
                                   [](const Family& family) { return family.scheme == nullptr; });
  const auto number = static_cast<std::uint32_t>(unused - families_.begin());
  if (unused == families_.end()) families_.emplace_back();
  families_[number].scheme = scheme;
  family_of_scheme_[scheme.get()] = number;
  return number;
}

// bodies_.size() if there is none.
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

void BodyRegistry::list_batches() {
  batches_.clear();
  for (const Family& family : families_) {
    for (const auto& batch : family.batches) batches_.push_back(batch.get());
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
