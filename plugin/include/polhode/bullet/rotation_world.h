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

/// A Bullet world whose bodies the library rotates: `RotationWorld<btDiscreteDynamicsWorld> world(...)`, with
/// the constructor arguments of Base. Base is btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt,
/// btSoftRigidDynamicsWorld, btMultiBodyDynamicsWorld, btSoftMultiBodyDynamicsWorld, or a class derived from
/// one.
///
/// Gives results bit-identical to RotationPlugin, and is faster if Base is one of these five classes: the
/// library then integrates the bodies itself, which saves three rotations by Bullet for each body and step.
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
  // In these stages, Bullet's own worlds only rotate and move the bodies in their list. An application's
  // class may do anything: it sees all bodies, Bullet rotates them, and the library replaces the rotation
  // afterwards.
  static constexpr bool kBulletsOwn =
      std::is_same_v<Base, btDiscreteDynamicsWorld> || std::is_same_v<Base, btDiscreteDynamicsWorldMt> ||
      std::is_same_v<Base, btSoftRigidDynamicsWorld> || std::is_same_v<Base, btMultiBodyDynamicsWorld> ||
      std::is_same_v<Base, btSoftMultiBodyDynamicsWorld>;

  RotationControl rotation_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
