#include "fuzz/world/body_slot.h"

#include <sanitizer/asan_interface.h>

#include <new>

namespace polhode::fuzz {

std::string text(const btVector3& v) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += ' ' + std::to_string(v[i]);
  return text + ';';
}

std::string numbers(const btRigidBody& body) {
  std::string numbers;
  for (int row = 0; row < 3; ++row) numbers += text(body.getWorldTransform().getBasis()[row]);
  numbers += text(body.getWorldTransform().getOrigin());
  numbers += text(body.getLinearVelocity());
  numbers += text(body.getAngularVelocity());
  for (int row = 0; row < 3; ++row) numbers += text(body.getInvInertiaTensorWorld()[row]);
  return numbers + " activation " + std::to_string(body.getActivationState());
}

void BodySlot::make(const btRigidBody::btRigidBodyConstructionInfo& info, bool in_place) {
  if (in_place) {
    ASAN_UNPOISON_MEMORY_REGION(memory_.data(), memory_.size());
    body_ = new (memory_.data()) btRigidBody(info);
  } else {
    heap_ = std::make_unique<btRigidBody>(info);
    body_ = heap_.get();
  }
  flags = body_->getFlags();
}

void BodySlot::destroy() {
  if (body_ == nullptr) return;
  if (heap_ == nullptr) {
    body_->~btRigidBody();
    ASAN_POISON_MEMORY_REGION(memory_.data(), memory_.size());
  }
  heap_.reset();
  body_ = nullptr;
  motion_state.reset();
}

}  // namespace polhode::fuzz
