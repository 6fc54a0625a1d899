#include "bullet/body_table.h"

#include <utility>

namespace polhode {
inline namespace POLHODE_PRECISION {

void BodyTable::align(const Bodies& bodies) {
  for (int i = 0; i < bodies.size(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (index < size_ && (*this)[index].address() == bodies[i]) {
      renew((*this)[index], *bodies[i]);
    } else {
      rearrange(bodies);
      return;
    }
  }
}

// Bodies came or went: every entry is looked up anew.
void BodyTable::rearrange(const Bodies& bodies) {
  for (int i = 0; i < bodies.size(); ++i) {
    const auto wanted = static_cast<std::size_t>(i);
    const std::size_t present = find_or_append(*bodies[i]);
    if (present != wanted) {
      std::swap((*this)[present], (*this)[wanted]);
      by_address_[(*this)[present].address()] = present;
      by_address_[bodies[i]] = wanted;
    }
    renew((*this)[wanted], *bodies[i]);
    remember_place(*bodies[i], wanted);
  }
}

std::size_t BodyTable::find_or_append(btRigidBody& body) {
  const std::size_t index = index_of(body);
  if (index == size_) {
    append(body);
    remember_place(body, index);
  }
  return index;
}

void BodyTable::forget_others(const Bodies& bodies) {
  shrink_to(static_cast<std::size_t>(bodies.size()));
  by_address_ = AddressTable();
}

void BodyTable::clear() {
  shrink_to(0);
  by_address_ = AddressTable();
  places_.clear();
}

void BodyTable::shrink_to(std::size_t size) {
  while (size_ > size) {
    --size_;
    blocks_.back().pop_back();
    if (blocks_.back().empty()) blocks_.pop_back();
  }
}

void BodyTable::append(btRigidBody& body) {
  if (size_ % kBlock == 0) {
    blocks_.emplace_back();
    blocks_.back().reserve(kBlock);
  }
  blocks_.back().emplace_back(body);
  if (!by_address_.empty()) by_address_.emplace(&body, size_);
  ++size_;
}

const ManagedBody* BodyTable::find(const btRigidBody& body) const {
  const std::size_t index = index_of(body);
  if (index == size_ || !(*this)[index].is_about(body)) return nullptr;
  return &(*this)[index];
}

ManagedBody& BodyTable::entry_of(btRigidBody& body) {
  ManagedBody& entry = (*this)[find_or_append(body)];
  renew(entry, body);
  return entry;
}

void BodyTable::renew(ManagedBody& entry, btRigidBody& body) {
  if (!entry.is_about(body)) entry = ManagedBody(body);
}

// size_ if there is none.
std::size_t BodyTable::index_of(const btRigidBody& body) const {
  const auto place = static_cast<std::size_t>(body.getWorldArrayIndex());
  if (place < places_.size() && places_[place] < size_ && (*this)[places_[place]].address() == &body) {
    return places_[place];
  }
  if (by_address_.empty()) {
    for (std::size_t i = 0; i < size_; ++i) by_address_.emplace((*this)[i].address(), i);
  }
  const auto found = by_address_.find(&body);
  if (found == by_address_.end()) return size_;
  remember_place(body, found->second);
  return found->second;
}

void BodyTable::remember_place(const btRigidBody& body, std::size_t index) const {
  if (body.getWorldArrayIndex() < 0) return;
  const auto place = static_cast<std::size_t>(body.getWorldArrayIndex());
  if (place >= places_.size()) {
    // Less in advance than the vector would take.
    if (place >= places_.capacity()) places_.reserve(place + place / 64 + 1);
    places_.resize(place + 1, kNowhere);
  }
  places_[place] = static_cast<std::uint32_t>(index);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
