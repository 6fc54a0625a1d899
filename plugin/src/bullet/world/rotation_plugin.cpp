#include "polhode/bullet/rotation_plugin.h"

#include <utility>

#include "bullet/internals/private_members.h"
#include "bullet/world/island_manager_hook.h"
#include "bullet/world/world_stepper.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What the world holds of the plugin: its first action and its island manager.
class RotationPlugin::Attachment final : public btActionInterface, public SolveListener {
 public:
  explicit Attachment(RotationPlugin& plugin)
      : plugin_(plugin), world_(plugin.rotation_.stepper_->world()), hook_(world_, *this) {
    world_.addAction(this);
    move_to_front();
  }

  // Bullet removes an action by putting the last one in its place: there the order of the others stays.
  ~Attachment() override {
    move_to_back();
    world_.removeAction(this);
  }

  bool is_in_place() const { return hook_.is_in_place(); }

  void before_solve() override {
    if (actions(world_)[0] != this) move_to_front();
    plugin_.rotation_.before_solve();
  }
  void updateAction(btCollisionWorld* /*world*/, btScalar dt) override {
    plugin_.rotation_.after_integration(dt);
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

  void world_dies() override {
    hook_.world_is_gone();
    plugin_.rotation_.stepper_->world_is_gone();
    plugin_.attachment_.reset();  // this object
  }

 private:
  int position() const {
    int position = 0;
    while (position < actions(world_).size() && actions(world_)[position] != this) ++position;
    return position;
  }
  void move_to_front() {
    for (int i = position(); i > 0 && i < actions(world_).size(); --i)
      std::swap(actions(world_)[i], actions(world_)[i - 1]);
  }
  void move_to_back() {
    for (int i = position(); i + 1 < actions(world_).size(); ++i)
      std::swap(actions(world_)[i], actions(world_)[i + 1]);
  }

  RotationPlugin& plugin_;
  btDiscreteDynamicsWorld& world_;
  IslandManagerHook hook_;
};

RotationPlugin::RotationPlugin(btDynamicsWorld& world) : rotation_(world) {
  attachment_ = std::make_unique<Attachment>(*this);
}

RotationPlugin::~RotationPlugin() = default;

void RotationPlugin::attach() {
  if (attached()) return;
  detach();
  rotation_.stepper_->attach();
  try {
    attachment_ = std::make_unique<Attachment>(*this);
  } catch (...) {
    detach();
    throw;
  }
}

void RotationPlugin::detach() {
  attachment_.reset();
  rotation_.stepper_->detach();
}

bool RotationPlugin::attached() const {
  return attachment_ != nullptr && attachment_->is_in_place();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
