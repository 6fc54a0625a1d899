#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <type_traits>
#include <utility>

#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// A world whose bodies are rotated by the library: `RotationWorld<btDiscreteDynamicsWorld> world(...)`, with
/// the constructor arguments of Base. Base is any discrete world: btDiscreteDynamicsWorld,
/// btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld, btMultiBodyDynamicsWorld (its rigid bodies; links of
/// a btMultiBody are Bullet's), or a subclass of the application's own.
///
/// Against RotationPlugin it also sees the start of a step: what the application changed between steps is
/// taken over before the solver runs, and a non-finite body is mended before it can reach its neighbours.
template <class Base>
class RotationWorld : public Base {
  static_assert(std::is_base_of<btDiscreteDynamicsWorld, Base>::value,
                "RotationWorld needs a discrete world (btDiscreteDynamicsWorld or a class derived from it); "
                "btSimpleDynamicsWorld has no step that could be hooked");

 public:
  template <class... Arguments>
  explicit RotationWorld(Arguments&&... arguments)
      : Base(std::forward<Arguments>(arguments)...), rotation_(*this) {}

  RotationControl& rotation() { return rotation_; }
  const RotationControl& rotation() const { return rotation_; }

  void addRigidBody(btRigidBody* body) override {
    Base::addRigidBody(body);
    rotation_.body_added(*body);
  }

  void addRigidBody(btRigidBody* body, int group, int mask) override {
    Base::addRigidBody(body, group, mask);
    rotation_.body_added(*body);
  }

  void removeRigidBody(btRigidBody* body) override {
    rotation_.body_removed(*body);
    Base::removeRigidBody(body);
  }

  void synchronizeMotionStates() override {
    Base::synchronizeMotionStates();
    rotation_.show_swollen_bodies();
  }

 protected:
  void predictUnconstraintMotion(btScalar dt) override {
    rotation_.begin_step();
    Base::predictUnconstraintMotion(dt);
  }

  void integrateTransforms(btScalar dt) override {
    Base::integrateTransforms(dt);
    rotation_.finish_step(dt);
  }

 private:
  RotationControl rotation_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
