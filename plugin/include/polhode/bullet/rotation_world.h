#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <type_traits>
#include <utility>

#include "polhode/bullet/rotation_control.h"

class btDiscreteDynamicsWorldMt;
class btSoftRigidDynamicsWorld;
class btMultiBodyDynamicsWorld;
class btSoftMultiBodyDynamicsWorld;

namespace polhode {
inline namespace POLHODE_PRECISION {

/// A world whose bodies are rotated by the library: `RotationWorld<btDiscreteDynamicsWorld> world(...)`, with
/// the constructor arguments of Base. Base is any discrete world: btDiscreteDynamicsWorld,
/// btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld, btMultiBodyDynamicsWorld, btSoftMultiBodyDynamicsWorld, or
/// a subclass of the application's own.
///
/// Gives the same bits as RotationPlugin and is faster: over one of Bullet's own five classes the library
/// integrates the bodies itself, where Bullet would turn each of them three times more in a step.
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

  void solveConstraints(btContactSolverInfo& info) override {
    rotation_.before_solve();
    Base::solveConstraints(info);
  }

  void synchronizeMotionStates() override {
    const auto bullet = [this] { Base::synchronizeMotionStates(); };
    if constexpr (kBulletsOwn) {
      rotation_.synchronize_motion_states(bullet);
    } else {
      bullet();
      rotation_.show_swollen_bodies();
    }
  }

 protected:
  void predictUnconstraintMotion(btScalar dt) override {
    const auto bullet = [this, dt] { Base::predictUnconstraintMotion(dt); };
    if constexpr (kBulletsOwn) {
      rotation_.predict_unconstrained_motion(dt, bullet);
    } else {
      bullet();
    }
  }

  void createPredictiveContacts(btScalar dt) override {
    const auto bullet = [this, dt] { Base::createPredictiveContacts(dt); };
    if constexpr (kBulletsOwn) {
      rotation_.create_predictive_contacts(dt, bullet);
    } else {
      bullet();
    }
  }

  void integrateTransforms(btScalar dt) override {
    const auto bullet = [this, dt] { Base::integrateTransforms(dt); };
    if constexpr (kBulletsOwn) {
      rotation_.integrate_transforms(dt, bullet);
    } else {
      bullet();
      rotation_.after_integration(dt);
    }
  }

 private:
  // Bullet's own worlds do nothing in these stages but turn and move the bodies in their list. An
  // application's class may do anything there: it sees all bodies, Bullet turns them, and the turn is
  // replaced.
  static constexpr bool kBulletsOwn =
      std::is_same_v<Base, btDiscreteDynamicsWorld> || std::is_same_v<Base, btDiscreteDynamicsWorldMt> ||
      std::is_same_v<Base, btSoftRigidDynamicsWorld> || std::is_same_v<Base, btMultiBodyDynamicsWorld> ||
      std::is_same_v<Base, btSoftMultiBodyDynamicsWorld>;

  RotationControl rotation_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
