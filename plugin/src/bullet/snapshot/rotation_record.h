#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bullet/batch/batch.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The part of a Drive that changes with time. The torque law itself belongs to the application's
/// configuration.
struct DriveRecord {
  Vector3 rotor_momentum_B = Vector3::Zero();
  Vector3 rotor_torque_B = Vector3::Zero();
  std::optional<Torque> last_torque;

  bool has_rotors() const { return !(rotor_momentum_B.isZero(0.0) && rotor_torque_B.isZero(0.0)); }
};

template <class Archive>
void serialize(Archive& archive, Torque& torque) {
  archive(torque.world_W, torque.body_B, torque.rotor_B);
}

template <class Archive>
void serialize(Archive& archive, DriveRecord& record) {
  archive(record.rotor_momentum_B, record.rotor_torque_B, record.last_torque);
}

/// Everything that the library stores of a body from one step to the next. A new member of Batch that a step
/// depends on needs one line in each of the three lists: here, in serialize, and in for_each_lane_field.
struct RotationRecord {
  std::string scheme;
  Quaternion q_WB = Quaternion::Identity();
  Vector3 omega_W = Vector3::Zero();
  Vector3 L_W = Vector3::Zero();
  std::vector<double> R_WB;    ///< column by column; empty if the scheme keeps a rotation
  std::vector<double> memory;  ///< the scheme's memory
  btVector3 written_omega_W = btVector3(0, 0, 0);
  btVector3 inverse_inertia_B = btVector3(0, 0, 0);
  btVector3 origin = btVector3(0, 0, 0);
  std::uint64_t steps = 0;
  std::uint32_t unresolved_steps = 0;
  bool diverged = false;
  bool state_was_set = false;
  std::array<bool, kIncidentKinds> reported{};
  std::optional<DriveRecord> drive;  ///< empty: no torque law and no rotors
};

template <class Archive>
void serialize(Archive& archive, RotationRecord& record) {
  archive(record.scheme, record.q_WB, record.omega_W, record.L_W, record.R_WB, record.memory,
          record.written_omega_W, record.inverse_inertia_B, record.origin, record.steps,
          record.unresolved_steps, record.diverged, record.state_was_set, record.reported, record.drive);
}

RotationRecord record_of(Batch& batch, std::size_t lane);

/// Returns the scheme of the record: `present`, the body's present scheme, if its name matches, else the
/// built-in or registered one of that name.
/// @throws std::invalid_argument if there is no scheme of that name, or the record does not match the scheme.
SchemePointer require_scheme_of(const RotationRecord& record, const SchemePointer& present);

/// Writes the record to a lane, whose scheme must be that of the record.
void write_to_lane(RotationRecord& record, Batch& batch, std::size_t lane) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
