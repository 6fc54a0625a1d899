#pragma once

#include <array>
#include <bitset>
#include <cstddef>

#include "bullet/lane_turn.h"
#include "bullet/managed_body.h"
#include "lanes/lane_scheme.h"

/// The usual case, of eight bodies at once: nobody but the solver touched them since the library wrote them.
/// What is done comes out as ManagedBody does it, to the last bit.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bodies that wait until there are eight.
struct BodyBlock {
  std::array<ManagedBody*, kLanes> bodies;
  std::size_t count = 0;

  bool is_full() const { return count == kLanes; }
  void add(ManagedBody& body) {
    bodies[count] = &body;
    ++count;
  }
};

using BlockLanes = std::bitset<kLanes>;

/// Predictions that are half made, see LaneTurn.
class Predictions {
 public:
  struct Begun {
    bool all;  ///< of the bodies; else nothing that shows is done
    BlockLanes free_to_turn;
  };

  /// begin_step and predict of a full block of bodies that may_be_untouched, where the application did no
  /// more to any of them than to kick it; ManagedBody::begin_untouched then has to be called for each.
  Begun begin(const BodyBlock& block, btScalar dt);
  void complete(btScalar dt);

 private:
  static constexpr std::size_t kBlocks = 2;

  std::array<std::array<btRigidBody*, kLanes>, kBlocks> bodies_;
  std::array<LaneTurn, kBlocks> turns_;
  std::size_t count_ = 0;
};

/// Of a full block of bodies that may_be_in_place: those that nobody but the solver, and Bullet's turn if
/// made, touched in the step. If that is all of them their whole step is taken, from prepare_step to
/// write_step; else nothing is done.
BlockLanes step_untouched(const BodyBlock& block, BulletsTurn bullets_turn, const LaneScheme& scheme,
                          btScalar dt);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
