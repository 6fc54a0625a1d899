#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <cstddef>
#include <vector>

#include "polhode/bullet/precision.h"

/// Snapshots: all that a step of a body, or of a whole world, depends on, as plain bytes. A world that is
/// restored takes the same steps, to the last bit, as the run that went on.
///
///   rollback   each peer keeps the snapshots of its last frames. When an input of an earlier frame arrives,
///              it restores the world of that frame and steps it again with all inputs.
///   lockstep   one peer sends the snapshot of its world to the others, at the start and to whoever joins
///              later. Each restores it in a world with the same bodies; then inputs alone are sent.
///   replay     the snapshot of the start and the inputs are the whole recording.
///
/// State is what a step changes, and what acts on the bodies at present. It is saved:
///
///   the library's    the scheme's name, q_WB, omega_W, L_W, R_WB where the scheme keeps one, what the scheme
///                    remembers, what was last written to Bullet, the counts of rotation_of, `diverged`,
///                    incidents already reported, the rotors' momentum and their motors' torque
///   of the bodies    pose, velocities, interpolated pose and velocities, inverse inertia in the world, force
///                    and torque, activation state and time, hit fraction
///   of the world     contact points with their impulses, overlapping pairs, the broadphase, the order of the
///                    lists, the joints' applied impulses and which joints are enabled, the solver's seed,
///                    the time, also that of torque laws
///
/// Configuration is what an application sets. It is the application's to keep: it knows what it changed, and
/// a restored world does not overwrite settings behind its back. Not saved: mass, inertia and shape
/// (compared: a snapshot of another body is refused), damping, factors, gravity, flags, friction, collision
/// filters, torque laws, joint limits and motors, solver settings, callbacks, motion states, user pointers. The scheme
/// counts as state, since the rest of a body's state belongs to it: restoring chooses the scheme of the
/// snapshot again.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Little-endian whatever the machine; may be stored and sent. Starts with a format version and the
/// precision, ends with a checksum against damage (not against an attacker).
using Snapshot = std::vector<std::byte>;

/// The order of the bodies and joints of a world, by which a snapshot of it tells them apart. Removing and
/// adding a body changes it: keep the order beside the snapshot, put bodies made anew in the place of those
/// that were deleted, and hand it to restore_world.
struct WorldOrder {
  std::vector<btCollisionObject*> objects;  ///< as in the world's getCollisionObjectArray()
  std::vector<btTypedConstraint*> joints;   ///< as in the world's getConstraint(i)
};

/// Returns the present order.
WorldOrder order_of(btDynamicsWorld& world);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
