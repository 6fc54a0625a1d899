#pragma once

#include <array>
#include <cstddef>

#include "bullet/body_block.h"
#include "bullet/lane_turn.h"

/// The start of a step, of eight bodies at once: nobody touched them since the library wrote them. What is
/// done comes out as ManagedBody does it, to the last bit.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Predictions that are half made, see LaneTurn.
class UntouchedPredictions {
 public:
  struct Begun {
    BlockLanes is_begun;  ///< if not of all, nothing is done, and it says which bodies are untouched
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

}  // namespace POLHODE_PRECISION
}  // namespace polhode
