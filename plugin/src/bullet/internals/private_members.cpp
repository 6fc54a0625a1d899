#include "bullet/internals/private_members.h"

#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyGearConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <BulletDynamics/Featherstone/btMultiBodySliderConstraint.h>
#include <LinearMath/btTransformUtil.h>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// An explicit instantiation may name private members ([temp.spec]). The friend functions return pointers to
// members, so no cast is needed.
template <class Value>
struct MemberOfBody {
  using Member = Value btRigidBody::*;
};
struct VectorOfMultibody {
  using Member = btVector3 btMultiBody::*;
};

// A counter of the bodies. All other members can be equal in two bodies: broadphases reuse proxy numbers,
// applications copy flags.
struct DebugBodyId : MemberOfBody<int> {
  friend Member member_of(DebugBodyId);
};

struct AdditionalDamping : MemberOfBody<bool> {
  friend Member member_of(AdditionalDamping);
};

struct InverseInertiaTensorW : MemberOfBody<btMatrix3x3> {
  friend Member member_of(InverseInertiaTensorW);
};

struct Velocities {
  using Member = btAlignedObjectArray<btScalar> btMultiBody::*;
  friend Member member_of(Velocities);
};

struct BaseForce : VectorOfMultibody {
  friend Member member_of(BaseForce);
};

struct BaseTorque : VectorOfMultibody {
  friend Member member_of(BaseTorque);
};

struct ChildPairs {
  using Member = btHashedSimplePairCache* btCompoundCompoundCollisionAlgorithm::*;
  friend Member member_of(ChildPairs);
};

template <class Tag, typename Tag::Member member>
struct Reveal {
  friend typename Tag::Member member_of(Tag) { return member; }
};

template struct Reveal<DebugBodyId, &btRigidBody::m_debugBodyId>;
template struct Reveal<AdditionalDamping, &btRigidBody::m_additionalDamping>;
template struct Reveal<InverseInertiaTensorW, &btRigidBody::m_invInertiaTensorWorld>;
template struct Reveal<Velocities, &btMultiBody::m_realBuf>;
template struct Reveal<ChildPairs, &btCompoundCompoundCollisionAlgorithm::m_childCollisionAlgorithmCache>;
template struct Reveal<BaseForce, &btMultiBody::m_baseForce>;
template struct Reveal<BaseTorque, &btMultiBody::m_baseTorque>;

// Gives access to protected members by pointers to members, formed in a derived class.
struct World : btDiscreteDynamicsWorld {
  static constexpr auto kIslandManager = &World::m_islandManager;
  static constexpr auto kActions = &World::m_actions;
  static constexpr auto kLocalTime = &World::m_localTime;
  static constexpr auto kFixedTimeStep = &World::m_fixedTimeStep;
  static constexpr auto kInterpolates = &World::m_latencyMotionStateInterpolation;
  static constexpr auto kShowsAll = &World::m_synchronizeAllMotionStates;
  static constexpr auto kPredictiveManifolds = &World::m_predictiveManifolds;
  static constexpr auto kJoints = &World::m_constraints;
};

struct CompoundAlgorithm : btCompoundCollisionAlgorithm {
  static constexpr auto kChildren = &CompoundAlgorithm::m_childCollisionAlgorithms;
};

struct AccumulatingHinge : btHingeAccumulatedAngleConstraint {
  static constexpr auto kAngle = &AccumulatingHinge::m_accumulatedAngle;
};

// Bullet's constraint classes each define these members, with the same names.
template <class Constraint>
struct Joined : Constraint {
  static constexpr auto kRigidBodyA = &Joined::m_rigidBodyA;
  static constexpr auto kRigidBodyB = &Joined::m_rigidBodyB;
};

template <class Constraint>
bool find_rigid_bodies(const btMultiBodyConstraint& constraint, std::array<const btRigidBody*, 2>& found) {
  const auto* const joint = dynamic_cast<const Constraint*>(&constraint);
  if (joint != nullptr)
    found = {joint->*Joined<Constraint>::kRigidBodyA, joint->*Joined<Constraint>::kRigidBodyB};
  return joint != nullptr;
}

// By default motion states lag a step behind, so that poses between two steps can be interpolated.
bool looks_back(const btDiscreteDynamicsWorld& world) {
  return world.*World::kInterpolates && world.*World::kFixedTimeStep != 0;
}

btScalar time_beside_step(const btDiscreteDynamicsWorld& world) {
  return world.*World::kLocalTime - world.*World::kFixedTimeStep;
}

}  // namespace

int body_identity(const btRigidBody& body) {
  return body.*member_of(DebugBodyId());
}

bool has_additional_damping(const btRigidBody& body) {
  return body.*member_of(AdditionalDamping());
}

btMatrix3x3& inverse_inertia_tensor_W(btRigidBody& body) {
  return body.*member_of(InverseInertiaTensorW());
}

bool is_finalized(const btMultiBody& multibody) {
  return (multibody.*member_of(Velocities())).size() > 0;
}

btVector3& base_force(btMultiBody& multibody) {
  return multibody.*member_of(BaseForce());
}

btVector3& base_torque(btMultiBody& multibody) {
  return multibody.*member_of(BaseTorque());
}

std::array<const btRigidBody*, 2> rigid_bodies_of(const btMultiBodyConstraint& constraint) {
  std::array<const btRigidBody*, 2> found{};
  find_rigid_bodies<btMultiBodyPoint2Point>(constraint, found) ||
      find_rigid_bodies<btMultiBodyFixedConstraint>(constraint, found) ||
      find_rigid_bodies<btMultiBodySliderConstraint>(constraint, found) ||
      find_rigid_bodies<btMultiBodyGearConstraint>(constraint, found);
  return found;
}

btSimulationIslandManager*& island_manager(btDiscreteDynamicsWorld& world) {
  return world.*World::kIslandManager;
}

btAlignedObjectArray<btActionInterface*>& actions(btDiscreteDynamicsWorld& world) {
  return world.*World::kActions;
}

btAlignedObjectArray<btPersistentManifold*>& predictive_manifolds(btDiscreteDynamicsWorld& world) {
  return world.*World::kPredictiveManifolds;
}

btAlignedObjectArray<btTypedConstraint*>& joints(btDiscreteDynamicsWorld& world) {
  return world.*World::kJoints;
}

btScalar& local_time(btDiscreteDynamicsWorld& world) {
  return world.*World::kLocalTime;
}

btScalar& fixed_time_step(btDiscreteDynamicsWorld& world) {
  return world.*World::kFixedTimeStep;
}

CompoundParts parts_of(btCollisionAlgorithm& algorithm) {
  auto* const compound = dynamic_cast<btCompoundCollisionAlgorithm*>(&algorithm);
  if (compound == nullptr) return {nullptr, nullptr};
  auto* const of_two = dynamic_cast<btCompoundCompoundCollisionAlgorithm*>(compound);
  return {&(compound->*CompoundAlgorithm::kChildren),
          of_two == nullptr ? nullptr : of_two->*member_of(ChildPairs())};
}

btScalar* accumulated_angle(btTypedConstraint& joint) {
  auto* const hinge = dynamic_cast<btHingeAccumulatedAngleConstraint*>(&joint);
  return hinge == nullptr ? nullptr : &(hinge->*AccumulatingHinge::kAngle);
}

// Uses the same conditions as btDiscreteDynamicsWorld::synchronizeMotionStates and
// synchronizeSingleMotionState.
bool shows_more_than_the_step_end(btDiscreteDynamicsWorld& world) {
  return world.*World::kShowsAll ||
         (looks_back(world) ? time_beside_step(world) : world.*World::kLocalTime) != 0;
}

btTransform pose_to_show(const btDiscreteDynamicsWorld& world, const btRigidBody& body) {
  const btTransform& pose_at_end = body.getInterpolationWorldTransform();
  const btScalar time =
      looks_back(world) ? time_beside_step(world) : world.*World::kLocalTime * body.getHitFraction();
  if (time == 0) return pose_at_end;
  btTransform pose;
  btTransformUtil::integrateTransform(pose_at_end, body.getInterpolationLinearVelocity(),
                                      body.getInterpolationAngularVelocity(), time, pose);
  return pose;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
