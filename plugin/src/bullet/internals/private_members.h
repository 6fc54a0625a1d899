#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>

#include "polhode/bullet/precision.h"

class btCollisionAlgorithm;
class btHashedSimplePairCache;
class btMultiBody;
class btMultiBodyConstraint;

/// Members of Bullet 3.24's classes that have no accessor, or none to write with. Everything the library
/// touches behind Bullet's interface is in this folder; third_party_notes/bullet.md lists it.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// @name btRigidBody
/// @{
/// A number that no other btRigidBody of this process has: tells a body from a deleted one at the same
/// address.
int body_identity(const btRigidBody& body);

/// btRigidBodyConstructionInfo::m_additionalDamping, which damps a slow body also at a damping of 0.
bool has_additional_damping(const btRigidBody& body);

/// The matrix that btRigidBody::updateInertiaTensor sets.
btMatrix3x3& inverse_inertia_tensor_W(btRigidBody& body);

/// Bullet's setters for these do more than the assignment, or take one body at a time.
inline btVector3& angular_velocity(btRigidBody& body) {
  return const_cast<btVector3&>(body.getAngularVelocity());
}
inline btVector3& interpolation_linear_velocity(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationLinearVelocity());
}
inline btVector3& interpolation_angular_velocity(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationAngularVelocity());
}
/// @}

/// @name btDiscreteDynamicsWorld
/// @{
btSimulationIslandManager*& island_manager(btDiscreteDynamicsWorld& world);
btAlignedObjectArray<btActionInterface*>& actions(btDiscreteDynamicsWorld& world);

/// Manifolds of predictive contacts, made anew in each step.
btAlignedObjectArray<btPersistentManifold*>& predictive_manifolds(btDiscreteDynamicsWorld& world);
/// The joints, in the order of getConstraint.
btAlignedObjectArray<btTypedConstraint*>& joints(btDiscreteDynamicsWorld& world);
/// The time between the last step and what stepSimulation was given so far, s.
btScalar& local_time(btDiscreteDynamicsWorld& world);
btScalar& fixed_time_step(btDiscreteDynamicsWorld& world);

/// Returns whether synchronizeMotionStates, called now, would show bodies at a time between two steps, or
/// objects that are not awake as well.
bool shows_more_than_the_step_end(btDiscreteDynamicsWorld& world);

/// The pose that synchronizeSingleMotionState, called now, would show of the body.
btTransform pose_to_show(const btDiscreteDynamicsWorld& world, const btRigidBody& body);
/// @}

/// @name Others
/// @{
/// The algorithms within that of a compound shape.
struct CompoundParts {
  /// By child, null for those that are far from the other body. A null pointer if the algorithm is another.
  btAlignedObjectArray<btCollisionAlgorithm*>* children;
  btHashedSimplePairCache* pairs;  ///< of the children of two compound shapes; null if there is one
};
CompoundParts parts_of(btCollisionAlgorithm& algorithm);

/// What getAccumulatedHingeAngle adds to; null if the joint is another.
btScalar* accumulated_angle(btTypedConstraint& joint);
/// @}

/// @name btMultiBody
/// @{
/// Returns whether finalizeMultiDof has made room for its velocities. Without, its getters read past the end.
bool is_finalized(const btMultiBody& multibody);

/// The application's, in the world's axes; Bullet only adds to them.
btVector3& base_force(btMultiBody& multibody);
btVector3& base_torque(btMultiBody& multibody);

/// The rigid bodies that one of Bullet's constraints joins to a multibody; null where there is none.
std::array<const btRigidBody*, 2> rigid_bodies_of(const btMultiBodyConstraint& constraint);
/// @}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
