#pragma once

#include "bullet/snapshot/archive.h"

/// The envelope of a record:
///
///   magic "PLHDSNAP", format version (4 bytes), kind (1), size of btScalar (1), length of the record (8),
///   the record, checksum of all bytes before (8)
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Increment when a record changes: a snapshot of another version is rejected.
inline constexpr std::uint32_t kSnapshotVersion = 1;

enum class SnapshotKind : std::uint8_t { body = 1, world = 2 };

/// Starts an envelope, to which the record is appended.
Snapshot open_envelope(SnapshotKind kind);
/// Completes the envelope.
void close_envelope(Snapshot& snapshot);
/// Returns a reader of the record.
/// @throws std::invalid_argument that says what is wrong with the bytes and what is valid.
Reader read_envelope(const Snapshot& snapshot, SnapshotKind kind);

template <class Record>
Snapshot to_snapshot(SnapshotKind kind, Record& record) {
  Snapshot snapshot = open_envelope(kind);
  Writer{snapshot}(record);
  close_envelope(snapshot);
  return snapshot;
}

template <class Record>
Record from_snapshot(SnapshotKind kind, const Snapshot& snapshot) {
  Reader reader = read_envelope(snapshot, kind);
  Record record;
  reader(record);
  reader.require_end();
  return record;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
