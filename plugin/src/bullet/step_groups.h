#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "bullet/body_block.h"
#include "bullet/managed_body.h"
#include "bullet/untouched_predictions.h"
#include "lanes/lane_scheme.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bodies that wait for their scheme's step, by scheme, so that a scheme takes many at once.
class StepGroups {
 public:
  /// begin_step and the prediction for a step of dt, of an own body; completed at the latest by
  /// complete_predictions.
  void begin(ManagedBody& body, btScalar dt);
  void complete_predictions(btScalar dt);

  /// Prepares the body's step; it is completed at the latest by complete_all.
  void step(ManagedBody& body, btScalar dt, BulletsTurn bullets_turn);
  void complete_all();

  /// Whether a body that was stepped has an incident to report; asked once.
  bool take_found_incidents() { return std::exchange(found_incidents_, false); }
  void note_incident() { found_incidents_ = true; }

 private:
  // As many as leave the processor's nearest cache room for what is computed with them.
  static constexpr std::size_t kGroups = 2;
  static constexpr std::size_t kBodies = 16;
  static constexpr std::size_t kPredictions = 32;

  struct Group {
    const RotationScheme* scheme = nullptr;
    const LaneScheme* lane_scheme = nullptr;  // the same, if it is one
    btScalar dt = 0;
    std::array<WaitingBodies, 2> waiting;  // by BulletsTurn
    // The others.
    std::size_t count = 0;
    std::array<ManagedBody*, kBodies> bodies;
    std::array<PendingStep, kBodies> steps;
  };

  void begin_alone(ManagedBody& body, btScalar dt);
  BlockLanes begin_together(const BodyBlock& block, btScalar dt);
  void turn_predictions(btScalar dt);

  Group& group_of(const RotationScheme& scheme);
  void step_alone(Group& group, ManagedBody& body, BulletsTurn bullets_turn);
  BlockLanes step_together(const Group& group, const BodyBlock& block, BulletsTurn bullets_turn);
  void note_incidents(const BodyBlock& block);
  void complete_pending(Group& group);
  void complete(Group& group);
  void start(Group& group);
  static void take_steps(Group& group);
  static void find_mean_velocities(Group& group);
  void write(Group& group);

  std::array<Group, kGroups> groups_;
  const bool turns_in_lanes_ = turns_in_lanes();
  WaitingBodies beginning_;
  UntouchedPredictions predictions_of_untouched_;
  std::array<BasisTurn, kPredictions> predictions_;
  std::size_t prediction_count_ = 0;
  BulletReplay replay_;
  std::size_t next_to_reuse_ = 0;
  bool found_incidents_ = false;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
