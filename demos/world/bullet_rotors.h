#pragma once

#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>

#include <memory>
#include <vector>

#include "scenario/scenario.h"
#include "world/contender_world.h"

namespace polhode::demos {

/// A disc about an axis of the body.
struct Wheel {
  int axis;
  double axial_moment;       ///< kg m^2
  double transverse_moment;  ///< kg m^2, part of the body's inertia

  Vector3 inertia_B() const;
  Vector3 transverse_inertia_B() const;
};

/// The part of the body's mass that each of its wheels has.
inline constexpr double kWheelMass = 0.25;

/// Returns a wheel for each axis that needs one: as large as the body's inertia lets it be, and so as slow as it can be
/// for its momentum.
std::vector<Wheel> wheels_for(const Drive& drive, const Vector3& inertia_B);

/// Rotors as users of Bullet make them: wheels in the centre of mass, each a btRigidBody on a btHingeConstraint. They
/// touch nothing. Their moments about their axes are not part of the body's inertia, as with the library's rotors.
class BulletRotors {
 public:
  /// The body must have its pose and velocity at the start already.
  BulletRotors(ContenderWorld& world, btRigidBody& body, const Body& description,
               const std::vector<Wheel>& wheels);
  ~BulletRotors();
  BulletRotors(const BulletRotors&) = delete;
  BulletRotors& operator=(const BulletRotors&) = delete;

  /// The momentum of each wheel about its axis, which the body's state has as its rotors'.
  Vector3 momentum_B() const;
  /// The whole momentum of all wheels.
  Vector3 angular_momentum_W() const;
  /// Turns the wheels by this torque, and the body the other way, until the next step.
  void apply_torque(const Vector3& torque_B);
  /// Bullet clears the force after the next step.
  void apply_acceleration(const Vector3& acceleration_W);

 private:
  struct MountedWheel {
    Wheel wheel;
    std::unique_ptr<btRigidBody> body;
    std::unique_ptr<btHingeConstraint> hinge;
  };

  MountedWheel mounted(ContenderWorld& world, const Wheel& wheel, const Body& description);

  btDiscreteDynamicsWorld& world_;
  btRigidBody& body_;
  btEmptyShape shape_;
  std::vector<MountedWheel> wheels_;
};

}  // namespace polhode::demos
