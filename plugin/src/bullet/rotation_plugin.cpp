#include "polhode/bullet/rotation_plugin.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

RotationPlugin::RotationPlugin(btDynamicsWorld& world) : world_(&world), rotation_(world) {
  attach();
}

RotationPlugin::~RotationPlugin() {
  detach();
}

void RotationPlugin::attach() {
  if (attached_ || world_ == nullptr) return;
  rotation_.take_on_world();
  world_->addAction(this);
  attached_ = true;
}

void RotationPlugin::detach() {
  if (!attached_) return;
  world_->removeAction(this);
  rotation_.leave_world();
  attached_ = false;
}

void RotationPlugin::world_is_gone() noexcept {
  rotation_.world_is_gone();
  world_ = nullptr;
  attached_ = false;
}

void RotationPlugin::updateAction(btCollisionWorld* /*world*/, btScalar dt) {
  rotation_.finish_step(dt);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
