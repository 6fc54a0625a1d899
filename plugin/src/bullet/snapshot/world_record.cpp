#include "bullet/snapshot/world_record.h"

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

JointRecord record_of(btTypedConstraint& joint) {
  const btScalar* const angle = accumulated_angle(joint);
  return {joint.getConstraintType(), joint.isEnabled(), joint.internalGetAppliedImpulse(),
          angle != nullptr ? *angle : btScalar(0)};
}

void write_to(const JointRecord& record, btTypedConstraint& joint) {
  joint.setEnabled(record.is_enabled);
  joint.internalSetAppliedImpulse(record.applied_impulse);
  if (btScalar* const angle = accumulated_angle(joint)) *angle = record.accumulated_angle;
}

ClockRecord clock_of(btDiscreteDynamicsWorld& world) {
  const auto* const solver = dynamic_cast<btSequentialImpulseConstraintSolver*>(world.getConstraintSolver());
  return {local_time(world), fixed_time_step(world), solver != nullptr ? solver->getRandSeed() : 0, 0.0};
}

void write_to(const ClockRecord& record, btDiscreteDynamicsWorld& world) {
  local_time(world) = record.local_time;
  fixed_time_step(world) = record.fixed_time_step;
  auto* const solver = dynamic_cast<btSequentialImpulseConstraintSolver*>(world.getConstraintSolver());
  if (solver != nullptr) solver->setRandSeed(static_cast<unsigned long>(record.solver_seed));
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
