#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <cstddef>
#include <vector>

#include "polhode/bullet/precision.h"

/// A snapshot contains, as plain bytes, everything that the steps of a body or of a whole world depend on. A
/// restored world takes the same steps as the original run, bit for bit.
///
///   rollback   each peer keeps the snapshots of its last frames. When an input for an earlier frame
///              arrives, the peer restores the world of that frame and repeats the steps with all inputs.
///   lockstep   one peer sends the snapshot of its world to the others, at the start and to each peer that
///              joins later. The receiver restores it in a world with the same bodies. From then on only
///              inputs are sent.
///   replay     the first snapshot and the inputs are the whole recording.
///
/// Snapshots contain the state, which is what a step changes or what acts on the bodies at present:
///
///   the library    the scheme's name, q_WB, omega_W, L_W, R_WB if the scheme keeps one, the scheme's
///                  memory, the values last written to Bullet, the counts and flags of rotation_of,
///                  incidents already reported, the rotors' momentum and their motors' torque
///   bodies         pose, velocities, interpolated pose and velocities, inverse inertia in world axes, force
///                  and torque, activation state and time, hit fraction
///   the world      contact points with their impulses, overlapping pairs, the broadphase, the order of the
///                  lists, the joints' applied impulses and enabled flags, the solver's seed, the world's
///                  time and the time passed to torque laws
///
/// Snapshots do not contain the configuration, which is what the application sets. The application must keep
/// it, and restoring does not overwrite it: damping, factors, gravity, flags, friction, collision filters,
/// torque laws, joint limits and motors, solver settings, callbacks, motion states, user pointers. Mass,
/// inertia and shape are only compared, so that a snapshot of another body is rejected. The scheme counts as
/// state, because the other state of the body belongs to it: restoring sets the snapshot's scheme.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bytes to store or send; little-endian on every machine. Begins with a format version and the precision,
/// and ends with a checksum, which detects damage but not tampering.
using Snapshot = std::vector<std::byte>;

/// The order of a world's bodies and joints, by which a snapshot identifies them. Removing and adding bodies
/// changes the world's order. To restore afterwards, keep the order with the snapshot, replace deleted bodies
/// by the new ones at the same positions, and pass the order to restore_world.
struct WorldOrder {
  std::vector<btCollisionObject*> objects;  ///< as in the world's getCollisionObjectArray()
  std::vector<btTypedConstraint*> joints;   ///< as in the world's getConstraint(i)
};

/// Returns the world's present order.
WorldOrder order_of(btDynamicsWorld& world);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
