// The scene of each kind. Constant vectors are in world axes.
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>

#include <algorithm>
#include <cmath>

#include "polhode/rotation_math.h"
#include "workprecision/joints/joint_scene.h"
#include "world/body_rotation.h"

namespace polhode::demos {

namespace {

// An axis in general position, along none of the world's axes.
const Vector3 kSpinAxis(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

class HingeScene : public JointScene {
 public:
  HingeScene(const Contender& contender, const JointStart& start)
      : HingeScene(contender, start, speed_of(start)) {}

  double joint_error() const override {
    return angle_between(rotation_of(body_).R_WB * spin_axis_B(), kSpinAxis);
  }

 protected:
  HingeScene(const Contender& contender, const JointStart& start, double start_speed)
      : JointScene(contender, start),
        body_(add_body(inertia_B(), start_orientation(kSpinAxis), Vector3::Zero(), start_speed * kSpinAxis,
                       Vector3::Zero())) {
    auto hinge = std::make_unique<btHingeConstraint>(body_, ground(), btVector3(0, 0, 0), btVector3(0, 0, 0),
                                                     to_bullet(spin_axis_B()), to_bullet(kSpinAxis));
    hinge_ = hinge.get();
    add_constraint(std::move(hinge));
    set_start_energy();
  }

  btHingeConstraint& hinge() { return *hinge_; }
  const btRigidBody& hinged_body() const { return body_; }

 private:
  static double speed_of(const JointStart& start) { return start.omega_dt / start.dt_s; }

  btRigidBody& body_;
  btHingeConstraint* hinge_ = nullptr;
};

/// Accelerates the body from rest to its speed within some two steps. The motor is strong enough to hold that
/// speed against any torque.
class MotorScene final : public HingeScene {
 public:
  MotorScene(const Contender& contender, const JointStart& start) : HingeScene(contender, start, 0.0) {
    const double impulse = moment_about_hinge() * speed() / 2;
    hinge().enableAngularMotor(true, static_cast<btScalar>(speed()), static_cast<btScalar>(impulse));
  }

  double reference_energy_J() const override { return 0.5 * moment_about_hinge() * speed() * speed(); }

  double speed_error() const override {
    return std::abs(rotation_of(hinged_body()).omega_W.dot(kSpinAxis) / speed() - 1.0);
  }

 private:
  double moment_about_hinge() const { return spin_axis_B().cwiseAbs2().dot(inertia_B()); }
};

/// Two different bodies, half a metre apart, that turn together about their common centre.
class WeldScene final : public JointScene {
 public:
  WeldScene(const Contender& contender, const JointStart& start)
      : JointScene(contender, start),
        a_(add_part(inertia_B(), start_orientation(kSpinAxis), -kArm)),
        b_(add_part(2.0 * inertia_B(), start_orientation(kSpinAxis) * kBesideA, kArm)),
        start_q_AB_(q_AB()) {
    add_constraint(std::make_unique<btFixedConstraint>(a_, b_, a_.getWorldTransform().inverse(),
                                                       b_.getWorldTransform().inverse()));
    set_start_energy();
  }

  double joint_error() const override { return logarithm(q_AB() * start_q_AB_.conjugate()).norm(); }

 private:
  static const Vector3 kArm;
  static const Quaternion kBesideA;

  btRigidBody& add_part(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& position_W) {
    const Vector3 omega_W = speed() * kSpinAxis;
    return add_body(inertia_B, q_WB, position_W, omega_W, omega_W.cross(position_W));
  }

  Quaternion q_AB() const { return rotation_of(a_).q_WB.conjugate() * rotation_of(b_).q_WB; }

  btRigidBody& a_;
  btRigidBody& b_;
  Quaternion start_q_AB_;
};

const Vector3 WeldScene::kArm(0.5 / 3.0, 0.25 / 3.0, 0.5 / 3.0);
const Quaternion WeldScene::kBesideA = exponential(Vector3(0.6, -0.3, 0.6));

/// Turns about a point 0.3 m from its centre, 27 degrees off the axis of spin.
class PointScene final : public JointScene {
 public:
  PointScene(const Contender& contender, const JointStart& start)
      : JointScene(contender, start),
        arm_B_(start_orientation(kSpinAxis).conjugate() * kArm),
        body_(add_body(inertia_B(), start_orientation(kSpinAxis), -kArm, speed() * kSpinAxis,
                       -speed() * kSpinAxis.cross(kArm))) {
    add_constraint(
        std::make_unique<btPoint2PointConstraint>(body_, ground(), to_bullet(arm_B_), btVector3(0, 0, 0)));
    set_start_energy();
  }

  double joint_error() const override {
    const Vector3 gap_W = from_bullet(body_.getCenterOfMassPosition()) + rotation_of(body_).R_WB * arm_B_;
    return gap_W.norm() / kArm.norm();
  }

 private:
  static const Vector3 kArm;  ///< from the centre to the point

  Vector3 arm_B_;
  btRigidBody& body_;
};

const Vector3 PointScene::kArm(0.2, 0.1, 0.2);

/// Cannot turn about the world's z axis.
class LockScene final : public JointScene {
 public:
  LockScene(const Contender& contender, const JointStart& start)
      : JointScene(contender, start),
        body_(add_body(inertia_B(), start_orientation(kFreeAxis), Vector3::Zero(), speed() * kFreeAxis,
                       Vector3::Zero())),
        q_WB_(rotation_of(body_).q_WB) {
    body_.setAngularFactor(btVector3(1, 1, 0));
    set_start_energy();
  }

  double joint_error() const override { return std::abs(turned_about_z_); }

 private:
  static const Vector3 kFreeAxis;

  void after_step() override {
    const Quaternion q_WB = rotation_of(body_).q_WB;
    turned_about_z_ += logarithm(q_WB * q_WB_.conjugate()).z();
    q_WB_ = q_WB;
  }

  btRigidBody& body_;
  Quaternion q_WB_;
  double turned_about_z_ = 0.0;
};

const Vector3 LockScene::kFreeAxis(0.6, 0.8, 0.0);

/// Swings through the orientation to which the spring pulls it, at the speed that gives an amplitude of
/// kAmplitude. Steps of symplectic Euler, as Bullet's, advance the phase of a spring k by p with sin(p/2) =
/// sqrt(k/I) dt/2. k is chosen so that p about the axis of I_1, the fastest, is omega_dt. The swing is
/// therefore stable for any omega_dt below pi.
class SpringScene final : public JointScene {
 public:
  SpringScene(const Contender& contender, const JointStart& start)
      : JointScene(contender, start),
        stiffness_(inertia_B()[0] * std::pow(2.0 * std::sin(start.omega_dt / 2.0) / start.dt_s, 2)),
        body_(add_body(inertia_B(), start_orientation(kSpinAxis), Vector3::Zero(),
                       start_orientation(kSpinAxis) * start_omega_B(), Vector3::Zero())),
        rest_q_WB_(rotation_of(body_).q_WB) {
    set_start_energy();
  }

  double joint_error() const override { return std::max(0.0, angle_W().norm() - kAmplitude); }

  double energy_J() const override {
    return JointScene::energy_J() + 0.5 * stiffness_ * angle_W().squaredNorm();
  }

 private:
  static constexpr double kAmplitude = 0.1;  // rad

  Vector3 start_omega_B() const {
    Vector3 omega_B;
    for (int i = 0; i < 3; ++i) {
      const double half_phase =
          std::asin(std::sin(start().omega_dt / 2.0) * std::sqrt(inertia_B()[0] / inertia_B()[i]));
      omega_B[i] = kAmplitude * spin_axis_B()[i] * std::sin(2.0 * half_phase) / start().dt_s;
    }
    return omega_B;
  }

  // The rotation from the rest orientation to the present one.
  Vector3 angle_W() const { return logarithm(rotation_of(body_).q_WB * rest_q_WB_.conjugate()); }

  void before_step() override { body_.applyTorque(to_bullet(-stiffness_ * angle_W())); }

  double stiffness_;  ///< N m/rad
  btRigidBody& body_;
  Quaternion rest_q_WB_;
};

}  // namespace

std::unique_ptr<JointScene> make_joint_scene(JointKind kind, const Contender& contender,
                                             const JointStart& start) {
  switch (kind) {
    case JointKind::hinge:
      return std::make_unique<HingeScene>(contender, start);
    case JointKind::motor:
      return std::make_unique<MotorScene>(contender, start);
    case JointKind::weld:
      return std::make_unique<WeldScene>(contender, start);
    case JointKind::point:
      return std::make_unique<PointScene>(contender, start);
    case JointKind::lock:
      return std::make_unique<LockScene>(contender, start);
    case JointKind::spring:
      break;
  }
  return std::make_unique<SpringScene>(contender, start);
}

}  // namespace polhode::demos
