#pragma once

#include <array>
#include <optional>

#include "bullet/batch/bullet_rows.h"
#include "polhode/bullet/precision.h"
#include "scheme_base/driven_step.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

struct Batch;
struct StepContext;

/// Data of a batch whose bodies have a Drive. Bodies without a Drive are kept in other batches, where drives
/// cost nothing.
struct DrivenLanes {
  std::array<Drive*, kLanes> drives{};  ///< null in a hole; owned by SchemeChoices

  // The present step.
  std::array<StepStart, kLanes> starts{};
  std::array<std::optional<Torque>, kLanes> last_torques;  ///< Drive::last_torque for the next step
  LaneBits law_failed;

  // The changes by the free step of constrained lanes.
  std::array<Vector3, kLanes> gain_W{};  ///< change of L_W
  std::array<Vector3, kLanes> rotor_end_B{};

  /// Copies everything but the drive, which must be set already.
  void move_from(const DrivenLanes& other, std::size_t from, std::size_t to);
  /// Returns the lanes whose drive acts, so that the scheme's own step is not enough.
  LaneBits acting(const LaneBits& lanes) const;
  Vector3Wide rotor_momentum_B() const;
};

/// @name Functions for a batch with driven lanes
/// @{
/// Records the start of the step. Call right before the solve.
void begin_drive(Batch& batch, const LaneBits& lanes, const StepContext& context);
/// Stores the changes by the free step, which ends in `end`.
void keep_gain(Batch& batch, const LaneBits& lanes, const WideState& end);
/// Returns omega_W plus the velocity change by the gain, at the orientation at the start.
Vector3Wide omega_with_gain_W(const Batch& batch);
/// Returns the rotors' momentum: in the given lanes that at the end of the step, in the others the present
/// one.
Vector3Wide rotor_end_B(const Batch& batch, const LaneBits& lanes);
Vector3Wide gain_W(const Batch& batch);
/// Stores the rotors' momentum and the torques at the end of the step, and notes failed laws.
void end_drive(Batch& batch, const LaneBits& lanes, const WideState& end);
/// @}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
