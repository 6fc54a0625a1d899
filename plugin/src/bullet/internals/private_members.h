#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>

#include "polhode/bullet/precision.h"

class btCollisionAlgorithm;
class btHashedSimplePairCache;
class btMultiBody;
class btMultiBodyConstraint;

/// Access to members of Bullet 3.24's classes that have no accessor, or no suitable one for writing. This
/// folder holds everything that bypasses Bullet's interface; third_party_notes/bullet.md lists it.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// @name btRigidBody
/// @{
/// Returns a number that is unique among all btRigidBody objects of the process. Distinguishes a body from a
/// deleted one at the same address.
int body_identity(const btRigidBody& body);

/// Returns btRigidBodyConstructionInfo::m_additionalDamping, which damps slow bodies even if their damping is
/// 0.
bool has_additional_damping(const btRigidBody& body);

/// Returns the matrix that btRigidBody::updateInertiaTensor sets.
btMatrix3x3& inverse_inertia_tensor_W(btRigidBody& body);

/// Direct access, since Bullet's setters do more than assign, or take one body at a time.
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

/// Returns the manifolds of predictive contacts, which each step creates again.
btAlignedObjectArray<btPersistentManifold*>& predictive_manifolds(btDiscreteDynamicsWorld& world);
/// Returns the joints in the order of getConstraint.
btAlignedObjectArray<btTypedConstraint*>& joints(btDiscreteDynamicsWorld& world);
/// Returns the time from the last step to the end of the time passed to stepSimulation, s.
btScalar& local_time(btDiscreteDynamicsWorld& world);
btScalar& fixed_time_step(btDiscreteDynamicsWorld& world);

/// Returns true if synchronizeMotionStates, called now, would write poses at a time between two steps, or of
/// objects that are not awake.
bool shows_more_than_the_step_end(btDiscreteDynamicsWorld& world);

/// Returns the pose that synchronizeSingleMotionState, called now, would write to the body's motion state.
btTransform pose_to_show(const btDiscreteDynamicsWorld& world, const btRigidBody& body);
/// @}

/// @name Others
/// @{
/// The algorithms inside the algorithm of a compound shape.
struct CompoundParts {
  /// By child; null for children far from the other body. A null pointer for an algorithm without children.
  btAlignedObjectArray<btCollisionAlgorithm*>* children;
  btHashedSimplePairCache* pairs;  ///< child pairs of two compound shapes; null if only one shape is compound
};
CompoundParts parts_of(btCollisionAlgorithm& algorithm);

/// Returns the angle that getAccumulatedHingeAngle accumulates; null for another kind of joint.
btScalar* accumulated_angle(btTypedConstraint& joint);
/// @}

/// @name btMultiBody
/// @{
/// Returns true if finalizeMultiDof has allocated the velocities. Otherwise getters read past the end of the
/// buffer.
bool is_finalized(const btMultiBody& multibody);

/// Return the application's force and torque, in world axes. Bullet itself can only add to these.
btVector3& base_force(btMultiBody& multibody);
btVector3& base_torque(btMultiBody& multibody);

/// Returns the rigid bodies that one of Bullet's constraints joins to a multibody; null if there is none.
std::array<const btRigidBody*, 2> rigid_bodies_of(const btMultiBodyConstraint& constraint);
/// @}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
