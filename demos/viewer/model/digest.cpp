#include "viewer/model/digest.h"

#include <cstring>

namespace polhode::demos {

namespace {

/// FNV-1a, byte by byte.
class Digest {
 public:
  void add(double value) {
    std::uint64_t bits = 0;
    static_assert(sizeof(bits) == sizeof(value));
    std::memcpy(&bits, &value, sizeof(bits));
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ ((bits >> (8 * byte)) & 0xFF)) * 0x100000001B3u;
    }
  }

  template <typename Derived>
  void add(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      for (Eigen::Index row = 0; row < matrix.rows(); ++row) add(matrix(row, column));
    }
  }

  std::uint64_t value() const { return value_ == 0 ? 1 : value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

}  // namespace

std::uint64_t digest_of(const Snapshot& snapshot) {
  const Sample& sample = snapshot.sample;
  Digest digest;
  digest.add(sample.state.q_WB.coeffs());
  digest.add(sample.state.R_WB);
  digest.add(sample.state.omega_W);
  digest.add(sample.state.L_W);
  if (sample.state.has_rotor()) digest.add(sample.state.rotor_momentum_B);
  digest.add(sample.position_W);
  digest.add(sample.energy_J);
  for (const Pose& pose : snapshot.others) {
    digest.add(pose.R_WB);
    digest.add(pose.position_W);
  }
  return digest.value();
}

}  // namespace polhode::demos
