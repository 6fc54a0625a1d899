#include "bullet/snapshot/rotation_record.h"

#include <algorithm>
#include <cmath>

#include "bullet/snapshot/archive.h"
#include "polhode/scheme_registry.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Calls copy(value of the record, values of the batch) for each pair.
template <class Copy>
void for_each_lane_field(RotationRecord& record, Batch& batch, const Copy& copy) {
  copy(record.q_WB.coeffs(), batch.q_WB.coeffs());
  copy(record.omega_W, batch.omega_W);
  copy(record.L_W, batch.L_W);
  copy(record.written_omega_W, batch.written_omega_W);
  copy(record.inverse_inertia_B, batch.inverse_inertia_B);
  copy(record.origin, batch.origin);
  copy(record.steps, batch.steps);
  copy(record.unresolved_steps, batch.unresolved_steps);
  copy(record.diverged, batch.diverged);
  copy(record.state_was_set, batch.state_was_set);
  for (std::size_t i = 0; batch.R_WB != nullptr && i < record.R_WB.size(); ++i)
    copy(record.R_WB[i], batch.R_WB->coeffRef(static_cast<Eigen::Index>(i)));
  for (std::size_t i = 0; i < record.memory.size(); ++i) copy(record.memory[i], batch.memory[i]);
  for (std::size_t i = 0; i < kIncidentKinds; ++i) copy(record.reported[i], batch.reported[i]);
}

struct CopyFromLane {
  std::size_t lane;

  template <class Doubles, class Values>
  void operator()(Eigen::MatrixBase<Doubles>& value, const Eigen::MatrixBase<Values>& rows) const {
    get_lane(lane, rows.derived(), value.derived());
  }
  void operator()(btVector3& value, const BulletRows& rows) const { value = vector_in_lane(rows, lane); }
  void operator()(double& value, const Wide& lanes) const { value = lanes[lane]; }
  void operator()(bool& value, const LaneBits& lanes) const { value = lanes[lane]; }
  template <class Value>
  void operator()(Value& value, const std::array<Value, kLanes>& lanes) const {
    value = lanes[lane];
  }
};

struct CopyToLane {
  std::size_t lane;

  template <class Doubles, class Values>
  void operator()(const Eigen::MatrixBase<Doubles>& value, Eigen::MatrixBase<Values>& rows) const {
    set_lane(lane, value.derived(), rows.derived());
  }
  void operator()(const btVector3& value, BulletRows& rows) const { set_vector_in_lane(lane, value, rows); }
  void operator()(double value, Wide& lanes) const { lanes.set(lane, value); }
  void operator()(bool value, LaneBits& lanes) const { lanes.set(lane, value); }
  template <class Value>
  void operator()(Value value, std::array<Value, kLanes>& lanes) const {
    lanes[lane] = value;
  }
};

constexpr std::size_t kNumbersOfR = 9;

std::size_t memory_rows_of(const RotationScheme& scheme) {
  const auto* const wide_scheme = dynamic_cast<const WideScheme*>(&scheme);
  return wide_scheme != nullptr ? wide_scheme->memory_rows() : 0;
}

SchemePointer find_by_name(const std::string& name, const SchemePointer& present) {
  if (present != nullptr && present->description().name == name) return present;
  for (const SchemePointer& scheme : all_schemes()) {
    if (scheme->description().name == name) return scheme;
  }
  refuse_snapshot("it uses the scheme \"" + name +
                  "\", which is unknown: register it (register_scheme), or set it for the body (set_scheme), "
                  "before restoring; known are " +
                  scheme_names());
}

}  // namespace

RotationRecord record_of(Batch& batch, std::size_t lane) {
  RotationRecord record;
  record.scheme = batch.scheme->description().name;
  record.R_WB.resize(batch.R_WB != nullptr ? kNumbersOfR : 0);
  record.memory.resize(batch.memory_rows());
  for_each_lane_field(record, batch, CopyFromLane{lane});
  if (batch.driven != nullptr) {
    const Drive& drive = *batch.driven->drives[lane];
    record.drive = {drive.rotor_momentum_B, drive.rotor_torque_B, drive.last_torque};
  }
  // Constants that overflowed are useless: reset them, so that they are computed again.
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(record.memory.begin(), record.memory.end(), is_finite))
    std::fill(record.memory.begin(), record.memory.end(), 0.0);
  return record;
}

SchemePointer require_scheme_of(const RotationRecord& record, const SchemePointer& present) {
  SchemePointer scheme = find_by_name(record.scheme, present);
  const bool keeps_rotation = scheme->description().rotation != Conservation::lost;
  if (record.memory.size() != memory_rows_of(*scheme) ||
      record.R_WB.size() != (keeps_rotation ? 0 : kNumbersOfR))
    refuse_snapshot("its data of the scheme \"" + record.scheme +
                    "\" do not match the scheme of this program");
  if (record.drive && record.drive->has_rotors() && !scheme->description().takes_rotors)
    refuse_snapshot("it has rotors, which the scheme \"" + record.scheme + "\" does not take");
  constexpr double kLargestError = 1e-9;  // of the length of a unit quaternion, after any number of steps
  if (!(std::abs(record.q_WB.squaredNorm() - 1.0) < kLargestError))
    refuse_snapshot("the quaternion of an orientation does not have length 1");
  return scheme;
}

void write_to_lane(RotationRecord& record, Batch& batch, std::size_t lane) noexcept {
  for_each_lane_field(record, batch, CopyToLane{lane});
  if (batch.driven == nullptr) return;
  const DriveRecord saved = record.drive.value_or(DriveRecord());
  Drive& drive = *batch.driven->drives[lane];
  drive.rotor_momentum_B = saved.rotor_momentum_B;
  drive.rotor_torque_B = saved.rotor_torque_B;
  drive.last_torque = saved.last_torque;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
