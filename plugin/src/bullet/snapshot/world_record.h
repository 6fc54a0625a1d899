#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstdint>
#include <vector>

#include "bullet/internals/broadphase_record.h"
#include "bullet/internals/contact_record.h"
#include "bullet/snapshot/object_record.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

struct JointRecord {
  std::int32_t type = 0;  ///< compared
  bool is_enabled = true;
  btScalar applied_impulse = 0;
  btScalar accumulated_angle = 0;  ///< for btHingeAccumulatedAngleConstraint only
};

template <class Archive>
void serialize(Archive& archive, JointRecord& record) {
  archive(record.type, record.is_enabled, record.applied_impulse, record.accumulated_angle);
}

/// The data of a world besides its bodies, contacts and joints.
struct ClockRecord {
  btScalar local_time = 0;
  btScalar fixed_time_step = 0;
  std::uint64_t solver_seed = 0;
  double law_time_s = 0;  ///< RotationControl::time
};

template <class Archive>
void serialize(Archive& archive, ClockRecord& record) {
  archive(record.local_time, record.fixed_time_step, record.solver_seed, record.law_time_s);
}

struct WorldRecord {
  std::vector<ObjectRecord> objects;     ///< in the world's order
  std::vector<std::int32_t> non_static;  ///< the world's list of non-static bodies, as indices in `objects`
  std::vector<JointRecord> joints;       ///< in the world's order
  BroadphaseRecord broadphase;
  ContactRecord contacts;
  ClockRecord clock;
};

template <class Archive>
void serialize(Archive& archive, WorldRecord& record) {
  archive(record.objects, record.non_static, record.joints, record.broadphase, record.contacts, record.clock);
}

JointRecord record_of(btTypedConstraint& joint);
void write_to(const JointRecord& record, btTypedConstraint& joint);
/// Returns the record without law_time_s.
ClockRecord clock_of(btDiscreteDynamicsWorld& world);
void write_to(const ClockRecord& record, btDiscreteDynamicsWorld& world);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
