// The library leaves a free-floating chain of two movable links to Bullet. The figures of plain Bullet are
// those of third_party_notes/bullet_multibodies.md.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "polhode/bullet/conversions.h"
#include "support/multibody_scene.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

enum class Joint { revolute, spherical };

std::unique_ptr<btMultiBody> make_chain(Joint joint, btScalar rate) {
  const btVector3 half(btScalar(0.5), 0, 0);  // from each centre of mass to the joint
  const btVector3 inertia(btScalar(0.2), btScalar(0.1), btScalar(0.15));
  const btQuaternion straight = btQuaternion::getIdentity();
  auto chain =
      std::make_unique<btMultiBody>(1, btScalar(1), btVector3(btScalar(0.1), btScalar(0.2), btScalar(0.3)),
                                    /*fixedBase=*/false, /*canSleep=*/false);
  if (joint == Joint::revolute) {
    chain->setupRevolute(0, 1, inertia, -1, straight, btVector3(0, 0, 1), half, half);
  } else {
    chain->setupSpherical(0, 1, inertia, -1, straight, half, half);
  }
  chain->finalizeMultiDof();
  chain->setLinearDamping(0);
  chain->setAngularDamping(0);
  chain->setBaseOmega(rate * btVector3(1, btScalar(0.3), btScalar(0.2)));
  if (joint == Joint::revolute) chain->setJointVel(0, rate / 2);
  return chain;
}

// Linear and angular momentum about the common centre of mass, kinetic energy, and inertia of the chain with
// its joint locked.
struct Whole {
  Vector3 centre, momentum_W, L_W;
  Matrix3 inertia_W;
  double mass, energy;
};
Whole whole_of(const btMultiBody& chain) {
  btVector3 omega_L[2], velocity_L[2];  // in each link's own axes
  chain.compTreeLinkVelocities(omega_L, velocity_L);
  const btQuaternion q_LW[2] = {chain.getWorldToBaseRot(),
                                chain.getParentToLocalRot(0) * chain.getWorldToBaseRot()};
  const btVector3 place[2] = {chain.getBasePos(),
                              chain.getBasePos() + quatRotate(q_LW[1].inverse(), chain.getRVector(0))};
  const btScalar mass[2] = {chain.getBaseMass(), chain.getLinkMass(0)};
  const btVector3 moments[2] = {chain.getBaseInertia(), chain.getLinkInertia(0)};
  Whole whole{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Matrix3::Zero(), 0.0, 0.0};
  for (int i = 0; i < 2; ++i) {
    whole.mass += static_cast<double>(mass[i]);
    whole.centre += static_cast<double>(mass[i]) * to_double(place[i]);
  }
  whole.centre /= whole.mass;
  for (int i = 0; i < 2; ++i) {
    const Matrix3 R_WL = to_double(btMatrix3x3(q_LW[i].inverse()));
    const double m = static_cast<double>(mass[i]);
    const Vector3 velocity_W = R_WL * to_double(velocity_L[i]);
    const Vector3 spin_L = to_double(moments[i]).cwiseProduct(to_double(omega_L[i]));
    const Vector3 r = to_double(place[i]) - whole.centre;
    whole.momentum_W += m * velocity_W;
    whole.L_W += R_WL * spin_L + m * r.cross(velocity_W);
    whole.energy += 0.5 * m * velocity_W.squaredNorm() + 0.5 * spin_L.dot(to_double(omega_L[i]));
    whole.inertia_W += R_WL * to_double(moments[i]).asDiagonal() * R_WL.transpose() +
                       m * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
  }
  return whole;
}

// Sets rigid-body velocities of the whole chain that give it the momenta of `wanted`.
void set_momenta(const Whole& wanted, btMultiBody& chain) {
  const Whole now = whole_of(chain);
  const Vector3 turn_W = now.inertia_W.inverse() * (wanted.L_W - now.L_W);
  const Vector3 base_from_centre = to_double(chain.getBasePos()) - now.centre;
  const Vector3 shift_W = (wanted.momentum_W - now.momentum_W) / now.mass + turn_W.cross(base_from_centre);
  chain.setBaseOmega(chain.getBaseOmega() + to_bullet(turn_W));
  chain.setBaseVel(chain.getBaseVel() + to_bullet(shift_W));
}

struct Drift {
  double energy, momentum;  // relative to the start
};
Drift drift_in_a_minute(Joint joint, int rate, int hertz, bool keeps_momenta) {
  MultibodyScene<> scene;
  const std::unique_ptr<btMultiBody> chain = make_chain(joint, static_cast<btScalar>(rate));
  scene.world().addMultiBody(chain.get());
  const Whole start = whole_of(*chain);
  for (int i = 0; i < 60 * hertz; ++i) {
    scene.step(1 / static_cast<btScalar>(hertz));
    if (keeps_momenta) set_momenta(start, *chain);
  }
  const Whole end = whole_of(*chain);
  scene.world().removeMultiBody(chain.get());
  return {end.energy / start.energy, end.L_W.norm() / start.L_W.norm()};
}

// Prints the table in the notes.
TEST(MovingLinks, GainEnergyAndMomentumInBullet) {
  std::printf("joint      rad/s    Hz   E/E0  L/L0   with momenta kept: E/E0\n");
  for (const Joint joint : {Joint::revolute, Joint::spherical}) {
    for (const int rate : {2, 8}) {
      for (const int hertz : {60, 240, 1000}) {
        const Drift alone = drift_in_a_minute(joint, rate, hertz, false);
        const Drift kept = drift_in_a_minute(joint, rate, hertz, true);
        std::printf("%-9s %6d %5d %6.4g %5.3g   %.4g\n", joint == Joint::revolute ? "revolute" : "spherical",
                    rate, hertz, alone.energy, alone.momentum, kept.energy);
        EXPECT_GE(alone.energy, 1.04);    // least measured: 1.048
        EXPECT_GE(alone.momentum, 1.03);  // 1.034
        EXPECT_NEAR(kept.momentum, 1.0, by_precision(1e-5, 1e-12));
        EXPECT_LE(kept.energy, alone.energy);
      }
    }
  }
}

TEST(MovingLinks, AreLeftToBulletToTheBit) {
  MultibodyScene<> plain;
  MultibodiesUnderRotationPlugin with;
  const std::unique_ptr<btMultiBody> expected = make_chain(Joint::spherical, 3);
  const std::unique_ptr<btMultiBody> chain = make_chain(Joint::spherical, 3);
  plain.world().addMultiBody(expected.get());
  with.world().addMultiBody(chain.get());
  plain.step(btScalar(1.0 / 60.0), 100);
  with.step(btScalar(1.0 / 60.0), 100);
  EXPECT_EQ(chain->getBaseOmega(), expected->getBaseOmega());
  EXPECT_EQ(chain->getWorldToBaseRot(), expected->getWorldToBaseRot());
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(chain->getJointVelMultiDof(0)[i], expected->getJointVelMultiDof(0)[i]);
  plain.world().removeMultiBody(expected.get());
  with.world().removeMultiBody(chain.get());
}

}  // namespace
}  // namespace polhode::testing
