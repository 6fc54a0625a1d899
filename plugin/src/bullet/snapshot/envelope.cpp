#include "bullet/snapshot/envelope.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr std::array<char, 8> kMagic = {'P', 'L', 'H', 'D', 'S', 'N', 'A', 'P'};
constexpr std::size_t kChecksumBytes = 8;

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kSnapshotVersion;
  std::uint8_t kind = 0;
  std::uint8_t scalar_bytes = sizeof(btScalar);
  std::uint64_t length = 0;
};
constexpr std::size_t kHeaderBytes = 22;

template <class Archive>
void serialize(Archive& archive, Header& header) {
  archive(header.magic, header.version, header.kind, header.scalar_bytes, header.length);
}

// FNV-1a over words of 8 bytes. Each step is invertible, so a change within one word always changes the sum.
std::uint64_t checksum(const std::byte* first, const std::byte* end) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  while (first != end) {
    std::uint64_t word = 0;
    for (int shift = 0; shift < 64 && first != end; shift += 8)
      word |= static_cast<std::uint64_t>(*first++) << shift;
    sum = (sum ^ word) * 0x100000001b3U;
    sum ^= sum >> 32;
  }
  return sum;
}

const char* name_of(std::uint8_t kind) {
  return kind == static_cast<std::uint8_t>(SnapshotKind::body) ? "one body" : "a world";
}

}  // namespace

Snapshot open_envelope(SnapshotKind kind) {
  Header header;
  header.kind = static_cast<std::uint8_t>(kind);
  Snapshot snapshot;
  Writer{snapshot}(header);
  return snapshot;
}

void close_envelope(Snapshot& snapshot) {
  Snapshot length_bytes;
  std::uint64_t length = snapshot.size() - kHeaderBytes;
  Writer{length_bytes}(length);
  std::copy(length_bytes.begin(), length_bytes.end(),
            snapshot.begin() + static_cast<std::ptrdiff_t>(kHeaderBytes - sizeof length));
  std::uint64_t sum = checksum(snapshot.data(), snapshot.data() + snapshot.size());
  Writer{snapshot}(sum);
}

Reader read_envelope(const Snapshot& snapshot, SnapshotKind kind) {
  if (snapshot.size() < kHeaderBytes + kChecksumBytes)
    refuse_snapshot("it has " + std::to_string(snapshot.size()) + " bytes: valid are at least " +
                    std::to_string(kHeaderBytes + kChecksumBytes));
  const std::byte* const first = snapshot.data();
  const std::byte* const end = first + snapshot.size() - kChecksumBytes;
  Header header;
  Reader(first, end)(header);
  if (header.magic != kMagic) refuse_snapshot("it does not begin with \"PLHDSNAP\"");
  if (header.version != kSnapshotVersion)
    refuse_snapshot("its format version is " + std::to_string(header.version) +
                    "; this library reads version " + std::to_string(kSnapshotVersion));
  if (header.scalar_bytes != sizeof(btScalar))
    refuse_snapshot("it was saved by a Bullet whose numbers have " + std::to_string(header.scalar_bytes) +
                    " bytes; here they have " + std::to_string(sizeof(btScalar)));
  if (header.length != static_cast<std::uint64_t>(end - first) - kHeaderBytes)
    refuse_snapshot("it has " + std::to_string(snapshot.size()) + " bytes, but its header says " +
                    std::to_string(header.length + kHeaderBytes + kChecksumBytes) +
                    ": it was truncated or extended");
  std::uint64_t sum = 0;
  Reader(end, end + kChecksumBytes)(sum);
  if (sum != checksum(first, end)) refuse_snapshot("its checksum is wrong: it is damaged");
  if (header.kind != static_cast<std::uint8_t>(kind))
    refuse_snapshot(std::string("it is of ") + name_of(header.kind) + "; " +
                    name_of(static_cast<std::uint8_t>(kind)) + " is required");
  return {first + kHeaderBytes, end};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
