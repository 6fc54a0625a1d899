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

/// The fraction of the body's mass that each of its wheels has.
inline constexpr double kWheelMass = 0.25;

/// Returns a wheel for each axis that needs one, as large as the body's inertia allows, and therefore as slow
/// as possible for its momentum.
std::vector<Wheel> wheels_for(const Drive& drive, const Vector3& inertia_B);

/// Rotors as a Bullet user would build them: wheels in the centre of mass, each a btRigidBody on a
/// btHingeConstraint, without collisions. Their moments about their axes are not part of the body's inertia,
/// as for the library's rotors.
class BulletRotors {
 public:
  /// Requires a body with its initial pose and velocity.
  BulletRotors(ContenderWorld& world, btRigidBody& body, const Body& description,
               const std::vector<Wheel>& wheels);
  ~BulletRotors();
  BulletRotors(const BulletRotors&) = delete;
  BulletRotors& operator=(const BulletRotors&) = delete;

  /// Returns the momentum of each wheel about its axis.
  Vector3 momentum_B() const;
  /// Returns the total angular momentum of all wheels.
  Vector3 angular_momentum_W() const;
  /// Applies this torque to the wheels, and the opposite one to the body, during the next step.
  void apply_torque(const Vector3& torque_B);
  /// Applies a force during the next step.
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
