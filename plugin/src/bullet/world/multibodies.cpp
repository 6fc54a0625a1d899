#include "bullet/world/multibodies.h"

#include <iterator>
#include <new>

namespace polhode {
inline namespace POLHODE_PRECISION {

Multibodies::Multibodies(btDynamicsWorld& world) : world_(dynamic_cast<btMultiBodyDynamicsWorld*>(&world)) {}

bool Multibodies::is_as_listed() const {
  const int count = world_ == nullptr ? 0 : world_->getNumMultibodies();
  if (lacks_memory_ || static_cast<std::size_t>(count) != listed_.size()) return false;
  for (int place = 0; place < count; ++place) {
    const btMultiBody* const multibody = world_->getMultiBody(place);
    const Listed& listed = listed_[static_cast<std::size_t>(place)];
    if (multibody != listed.multibody) return false;
    if (multibody != nullptr && turns_as_one_body(*multibody) != listed.is_one_body) return false;
  }
  return true;
}

void Multibodies::synchronize() noexcept {
  if (is_as_listed()) return;
  for (auto& [multibody, known] : known_) known.index = known.place = -1;
  listed_.clear();
  bodies_.clear();
  lacks_memory_ = false;
  may_have_absent_ = true;
  const int count = world_ == nullptr ? 0 : world_->getNumMultibodies();
  for (int place = 0; place < count; ++place) {
    btMultiBody* const multibody = world_->getMultiBody(place);
    const bool is_one_body = multibody != nullptr && turns_as_one_body(*multibody);
    try {
      listed_.push_back({multibody, is_one_body});
      if (is_one_body) add(*multibody, place);
    } catch (const std::bad_alloc&) {
      lacks_memory_ = true;
    }
  }
}

void Multibodies::add(btMultiBody& multibody, int place) {
  MultibodyProxy& proxy = proxy_of(multibody);
  Known& known = known_.find(&multibody)->second;
  if (known.index >= 0) return;  // Bullet allows adding a multibody twice
  bodies_.push_back(&proxy.body());
  known.index = static_cast<int>(bodies_.size()) - 1;
  known.place = place;
  proxy.body().setWorldArrayIndex(known.index);
}

void Multibodies::forget_absent() noexcept {
  if (lacks_memory_ || !may_have_absent_) return;
  may_have_absent_ = false;
  for (auto it = known_.begin(); it != known_.end();)
    it = it->second.index < 0 ? known_.erase(it) : std::next(it);
}

MultibodyProxy& Multibodies::proxy_of(btMultiBody& multibody) {
  const auto found = known_.find(&multibody);
  if (found != known_.end()) return *found->second.proxy;
  auto proxy = std::make_unique<MultibodyProxy>(multibody);
  may_have_absent_ = true;
  return *known_.emplace(&multibody, Known{std::move(proxy)}).first->second.proxy;
}

const btRigidBody* Multibodies::known_proxy_of(const btMultiBody& multibody) const {
  const auto found = known_.find(&multibody);
  return found == known_.end() ? nullptr : &found->second.proxy->body();
}

void Multibodies::world_is_gone() noexcept {
  world_ = nullptr;
  synchronize();
}

int Multibodies::index_of(const btMultiBody& multibody) const {
  const auto found = known_.find(&multibody);
  return found == known_.end() ? -1 : found->second.index;
}

bool Multibodies::has(const btMultiBody& multibody) const {
  const auto found = known_.find(&multibody);
  const int place = found == known_.end() ? -1 : found->second.place;
  const bool is_there =
      place >= 0 && place < world_->getNumMultibodies() && world_->getMultiBody(place) == &multibody;
  return is_there && turns_as_one_body(multibody);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
