// Random bodies on each kind of joint, at up to 3 rad per step: none diverges or gains energy, and the joints
// hold as in plain Bullet.
#include <gtest/gtest.h>

#include <random>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/uniform.h"

namespace polhode::testing {
namespace {

constexpr double kDt = 1.0 / 60;
constexpr int kBodiesOfEachKind = 40;
constexpr int kSeconds = 5;

enum class Kind { hinge_to_world, hinge_of_two, weld, point };

const char* name_of(Kind kind) {
  constexpr const char* kNames[] = {"hinge to the world", "hinge of two", "weld", "point joint"};
  return kNames[static_cast<int>(kind)];
}

/// Moments with ratios up to 20, any tilt, 1 to 180 rad/s about z.
struct Draw {
  explicit Draw(std::mt19937& random) {
    const auto uniform = [&] { return testing::uniform(random, 0, 1); };
    const auto direction = [&] {
      const double x = uniform() - 0.5, y = uniform() - 0.5;
      return vector(x, y, uniform() - 0.5).normalized();
    };
    const double ratio = std::pow(20.0, uniform()), middle = std::pow(ratio, uniform());
    speed = std::pow(180.0, uniform());
    inertia_B = vector(0.1, 0.1 * middle, 0.1 * ratio);
    if (uniform() < 0.5) std::swap(inertia_B[0], inertia_B[2]);
    const btVector3 axis = direction();
    q_WB = btQuaternion(axis, btScalar(3 * uniform()));
    const btVector3 other_axis = direction();
    other_q_WB = btQuaternion(other_axis, btScalar(3 * uniform()));
  }

  btVector3 inertia_B;
  btQuaternion q_WB, other_q_WB;
  double speed;

  double radians_a_step() const { return speed * kDt; }
};

/// The bodies of one draw on one kind of joint. `joint_off()` is in rad, for a point joint in m.
template <class AnyScene>
class Jointed {
 public:
  Jointed(AnyScene& scene, Kind kind, const Draw& draw) : kind_(kind) {
    a_ = &add(scene, draw.inertia_B, draw.q_WB, vector(0, 0, draw.speed), btVector3(0, 0, 0));
    const btMatrix3x3 to_A = a_->getWorldTransform().getBasis().transpose();
    axis_A_ = to_double(to_A * btVector3(0, 0, 1));
    if (kind == Kind::hinge_of_two || kind == Kind::weld) {
      const btVector3 omega_W = vector(0, 0, kind == Kind::weld ? draw.speed : 0);
      b_ = &add(scene, draw.inertia_B * 2, draw.other_q_WB, omega_W, vector(0, 0, 0.5));
      R_AB_ = basis_of(*a_).transpose() * basis_of(*b_);
    }
    join(scene, to_A);
    scene.world().getSolverInfo().m_numIterations = 30;
  }

  double energy() const { return energy_of(*a_) + (b_ != nullptr ? energy_of(*b_) : 0); }

  double joint_off() const {
    switch (kind_) {
      case Kind::hinge_to_world:
        return angle_between_axes(basis_of(*a_) * axis_A_, Vector3::UnitZ());
      case Kind::hinge_of_two:
        return angle_between_axes(basis_of(*a_) * axis_A_, basis_of(*b_) * axis_B_);
      case Kind::weld:
        return angle_between(Matrix3(basis_of(*a_).transpose() * basis_of(*b_)), R_AB_);
      case Kind::point:
        break;
    }
    return to_double(a_->getWorldTransform() * to_bullet(pivot_A_) - kPivot).norm();
  }

 private:
  static btRigidBody& add(AnyScene& scene, const btVector3& inertia_B, const btQuaternion& q_WB,
                          const btVector3& omega_W, const btVector3& origin) {
    btRigidBody& body = scene.add(1, inertia_B, btTransform(q_WB, origin), scene.box(vector(0.1, 0.1, 0.1)));
    body.setAngularVelocity(omega_W);
    return body;
  }

  void join(AnyScene& scene, const btMatrix3x3& to_A) {
    const btVector3 z(0, 0, 1);
    if (kind_ == Kind::hinge_to_world) {
      scene.template join<btHingeConstraint>(*a_, btVector3(0, 0, 0), to_A * z);
    } else if (kind_ == Kind::hinge_of_two) {
      const btMatrix3x3 to_B = b_->getWorldTransform().getBasis().transpose();
      axis_B_ = to_double(to_B * z);
      scene.template join<btHingeConstraint>(*a_, *b_, to_A * vector(0, 0, 0.25), to_B * vector(0, 0, -0.25),
                                             to_A * z, to_B * z);
    } else if (kind_ == Kind::weld) {
      scene.template join<btFixedConstraint>(*a_, *b_, a_->getWorldTransform().inverse(),
                                             b_->getWorldTransform().inverse());
    } else {
      pivot_A_ = to_double(to_A * kPivot);
      scene.template join<btPoint2PointConstraint>(*a_, to_A * kPivot);
    }
  }

  inline static const btVector3 kPivot{btScalar(0.1), 0, btScalar(-0.3)};

  Kind kind_;
  btRigidBody* a_ = nullptr;
  btRigidBody* b_ = nullptr;
  Vector3 axis_A_, axis_B_, pivot_A_;
  Matrix3 R_AB_;
};

/// Largest values after the first second.
struct Run {
  double highest_energy = 0;  // relative to the start
  double joint_off = 0;
};

template <class AnyScene>
Run run(AnyScene& scene, Kind kind, const Draw& draw, const int* flags = nullptr) {
  const Jointed<AnyScene> jointed(scene, kind, draw);
  if (flags != nullptr) {
    for (const auto& body : scene.bodies()) body->setFlags(*flags);
  }
  const double start = jointed.energy();
  Run run;
  for (int i = 0; i < 60 * kSeconds; ++i) {
    scene.step(btScalar(kDt));
    const double energy = jointed.energy() / start;
    if (!(energy < 1e6)) return {1e6, 1e6};  // the body diverged
    if (i < 60) continue;
    run.highest_energy = std::max(run.highest_energy, energy);
    run.joint_off = std::max(run.joint_off, jointed.joint_off());
  }
  return run;
}

struct BulletsRuns {
  double energy_by_default;
  double worst_joint_off;  // among its four modes
};

BulletsRuns run_bullets(Kind kind, const Draw& draw) {
  BulletsRuns runs{0, 0};
  for (const int flags : {0, static_cast<int>(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT),
                          static_cast<int>(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD),
                          static_cast<int>(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)}) {
    Scene<> scene;
    const Run bullets = run(scene, kind, draw, &flags);
    runs.worst_joint_off = std::max(runs.worst_joint_off, bullets.joint_off);
    runs.energy_by_default = bullets.highest_energy;  // the last mode is the default
  }
  return runs;
}

template <class Way>
class RandomJoints : public ::testing::Test {};
TYPED_TEST_SUITE(RandomJoints, BothWays, WayName);

TYPED_TEST(RandomJoints, HoldAndGainNoEnergy) {
  int resolved_count = 0;
  for (const Kind kind : {Kind::hinge_to_world, Kind::hinge_of_two, Kind::weld, Kind::point}) {
    std::mt19937 random(12345 + static_cast<unsigned>(kind));
    for (int i = 0; i < kBodiesOfEachKind; ++i) {
      const Draw draw(random);
      SCOPED_TRACE(std::string(name_of(kind)) + " " + std::to_string(i) + ", " +
                   std::to_string(draw.radians_a_step()) + " rad a step");
      TypeParam scene;
      const Run ours = run(scene, kind, draw);
      const BulletsRuns bullets = run_bullets(kind, draw);
      const bool resolved = draw.radians_a_step() <= 0.5;
      // measured at most 1.015 up to half a radian per step, 1.074 beyond; the targets are 1.02 and 1.3
      EXPECT_LE(ours.highest_energy, std::max(resolved ? 1.02 : 1.1, bullets.energy_by_default));
      // measured at most 1.1e-4 rad more than Bullet, and no more than Bullet above half a radian per step
      EXPECT_LE(ours.joint_off, bullets.worst_joint_off + 1e-3);
      if (resolved) ++resolved_count;
    }
  }
  EXPECT_GT(resolved_count, 80);
}

}  // namespace
}  // namespace polhode::testing
