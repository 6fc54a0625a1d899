#pragma once

#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <memory>
#include <vector>

#include "polhode/rotation_state.h"
#include "workprecision/joints/joint_kind.h"
#include "world/contender_world.h"

namespace polhode::demos {

/// The start of a scene.
struct JointStart {
  double omega_dt;       ///< turn of the body in a step, rad; for a spring the phase of its oscillation
  double inertia_ratio;  ///< I_3/I_1
  double tilt;           ///< of the spin from the axis of I_1, towards the middle between the other axes, rad
  double dt_s;
};

/// One or two constrained bodies in their own world: no gravity, damping, contact or sleep, 30 solver
/// iterations. Everything is measured on Bullet's bodies, as an application sees them.
class JointScene {
 public:
  virtual ~JointScene();
  JointScene(const JointScene&) = delete;
  JointScene& operator=(const JointScene&) = delete;

  void step();

  /// Returns the present violation of the constraint, rad.
  virtual double joint_error() const = 0;
  /// Returns the kinetic energy of all bodies, plus the energy of a spring.
  virtual double energy_J() const;
  /// Returns the energy that energy_J() is compared with: the initial energy, or that at a motor's target
  /// speed.
  virtual double reference_energy_J() const { return start_energy_J_; }
  /// Returns the error of a motor's speed relative to its target; 0 without a motor.
  virtual double speed_error() const { return 0.0; }

  /// Returns the constrained body; a weld has two.
  btRigidBody& body(std::size_t index = 0) { return *bodies_.at(index); }

  /// Returns true if a body is not finite, exceeds the library's limits, is reported as diverged by the
  /// library, or has gained so much energy that the run is useless.
  bool diverged() const;

 protected:
  JointScene(const Contender& contender, const JointStart& start);

  /// Adds a body that collides with nothing.
  btRigidBody& add_body(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& position_W,
                        const Vector3& omega_W, const Vector3& velocity_W);
  void add_constraint(std::unique_ptr<btTypedConstraint> constraint);
  void set_start_energy() { start_energy_J_ = energy_J(); }

  virtual void before_step() {}
  virtual void after_step() {}

  const JointStart& start() const { return start_; }
  /// Returns the speed of the spin, rad/s.
  double speed() const { return start_.omega_dt / start_.dt_s; }
  Vector3 inertia_B() const;
  /// Returns the axis of spin in body axes.
  Vector3 spin_axis_B() const;
  /// Returns the orientation in which the axis of spin lies along that axis of the world.
  Quaternion start_orientation(const Vector3& spin_axis_W) const;

  /// Returns a fixed body for joints to the world. Each scene has its own, because all threads share
  /// btTypedConstraint::getFixedBody().
  btRigidBody& ground() { return ground_; }

 private:
  JointStart start_;
  double start_energy_J_ = 0.0;
  btSphereShape shape_{btScalar(0.1)};
  btRigidBody ground_{btScalar(0), nullptr, nullptr};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  ContenderWorld world_;  ///< declared after the objects it uses, so that it is destroyed first
};

std::unique_ptr<JointScene> make_joint_scene(JointKind kind, const Contender& contender,
                                             const JointStart& start);

}  // namespace polhode::demos
