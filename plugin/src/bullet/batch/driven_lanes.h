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

/// The numbers that a batch keeps of bodies that have a Drive. Bodies with and without one are never in the same
/// batch, so that the latter pay nothing.
struct DrivenLanes {
  std::array<Drive*, kLanes> drives{};  ///< null in a hole; SchemeChoices holds them

  // The step under way.
  std::array<StepStart, kLanes> starts{};
  std::array<std::optional<Torque>, kLanes> last_torques;  ///< Drive::last_torque of the next step
  LaneBits law_failed;

  // Of constrained lanes: what the free step would change.
  std::array<Vector3, kLanes> gain_W{};  ///< of L_W
  std::array<Vector3, kLanes> rotor_end_B{};

  /// Takes over all but the drive, which is there already.
  void move_from(const DrivenLanes& other, std::size_t from, std::size_t to);
  /// Those of the lanes whose step is not the scheme's own alone.
  LaneBits acting(const LaneBits& lanes) const;
  Vector3Wide rotor_momentum_B() const;
};

/// @name For lanes of a batch with driven lanes
/// @{
/// Right before the solve.
void begin_drive(Batch& batch, const LaneBits& lanes, const StepContext& context);
/// Notes what the free step, which ends in `end`, changes.
void keep_gain(Batch& batch, const LaneBits& lanes, const WideState& end);
/// omega_W, and what the gain adds to it at the orientation of the start.
Vector3Wide omega_with_gain_W(const Batch& batch);
/// The rotors, and in the lanes what they have at the end.
Vector3Wide rotor_end_B(const Batch& batch, const LaneBits& lanes);
Vector3Wide gain_W(const Batch& batch);
/// The step has been taken: its rotors and torques are those of the next start.
void end_drive(Batch& batch, const LaneBits& lanes, const WideState& end);
/// @}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
