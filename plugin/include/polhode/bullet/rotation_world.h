#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <type_traits>
#include <utility>

#include "polhode/bullet/rotation_control.h"

class btDiscreteDynamicsWorldMt;
class btSoftRigidDynamicsWorld;
class btMultiBodyDynamicsWorld;

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

  void updateAabbs() override {
    if (kBulletsOwn) {
      rotation_.update_boxes();
    } else {
      Base::updateAabbs();
    }
  }

  void synchronizeMotionStates() override {
    if (bullet_shows_poses()) {
      Base::synchronizeMotionStates();
      rotation_.show_swollen_bodies();
    } else {
      rotation_.show_own_bodies();
      with_own_bodies_hidden([&] { Base::synchronizeMotionStates(); });
      rotation_.show_other_swollen_bodies();
    }
  }

 protected:
  void predictUnconstraintMotion(btScalar dt) override {
    if (kBulletsOwn) {
      rotation_.begin_step_and_predict(dt);
    } else {
      rotation_.begin_step();
    }
    with_own_bodies_hidden([&] { Base::predictUnconstraintMotion(dt); });
  }

  void createPredictiveContacts(btScalar dt) override {
    with_own_bodies_hidden([&] { Base::createPredictiveContacts(dt); });
  }

  void integrateTransforms(btScalar dt) override {
    if (kBulletsOwn) rotation_.move_and_rotate_own_bodies(dt);
    with_own_bodies_hidden([&] { Base::integrateTransforms(dt); });
    if (kBulletsOwn) {
      rotation_.finish_other_bodies(dt);
    } else {
      rotation_.finish_step(dt);
    }
  }

 private:
  // Bullet's own worlds do nothing in these phases but turn and move the bodies in their list. What an
  // application's class does there is not known: it sees all bodies, Bullet turns them and the turn is
  // replaced.
  static constexpr bool kBulletsOwn =
      std::is_same_v<Base, btDiscreteDynamicsWorld> || std::is_same_v<Base, btDiscreteDynamicsWorldMt> ||
      std::is_same_v<Base, btSoftRigidDynamicsWorld> || std::is_same_v<Base, btMultiBodyDynamicsWorld>;

  // Bullet's turn is due between two steps, where motion states are interpolated.
  bool bullet_shows_poses() const {
    const bool interpolates = this->m_latencyMotionStateInterpolation && this->m_fixedTimeStep != 0
                                  ? this->m_localTime != this->m_fixedTimeStep
                                  : this->m_localTime != 0;
    return !kBulletsOwn || interpolates || this->m_synchronizeAllMotionStates;
  }

  template <class Act>
  void with_own_bodies_hidden(const Act& act) {
    if (!kBulletsOwn) return act();
    struct Hidden {
      explicit Hidden(RotationControl& control) : rotation(control) { rotation.hide_own_bodies(); }
      ~Hidden() { rotation.unhide_own_bodies(); }
      RotationControl& rotation;
    };
    const Hidden hidden(rotation_);
    act();
  }

  RotationControl rotation_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
