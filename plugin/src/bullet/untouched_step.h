#pragma once

#include "bullet/body_block.h"
#include "lanes/lane_scheme.h"

/// The end of a step, of eight bodies at once: nobody but the solver touched them since the library wrote
/// them. What is done comes out as ManagedBody does it, to the last bit.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Of a full block of bodies that may_be_in_place: those that nobody but the solver, and Bullet's turn if
/// made, touched in the step. If that is all of them their whole step is taken, from prepare_step to
/// write_step; else nothing is done.
BlockLanes step_untouched(const BodyBlock& block, BulletsTurn bullets_turn, const LaneScheme& scheme,
                          btScalar dt);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
