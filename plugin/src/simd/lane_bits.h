#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "simd/registers.h"

namespace polhode {

/// One bit for each lane, in one byte: a std::bitset<8> takes eight bytes.
class LaneBits {
 public:
  LaneBits() = default;
  /// Bit i of `bits` belongs to lane i.
  explicit LaneBits(unsigned bits) : bits_(static_cast<std::uint8_t>(bits)) {}

  bool operator[](std::size_t lane) const { return (bits_ >> lane & 1U) != 0; }
  void set(std::size_t lane, bool value = true) {
    const auto bit = static_cast<std::uint8_t>(1U << lane);
    bits_ = static_cast<std::uint8_t>(value ? bits_ | bit : bits_ & ~bit);
  }
  void reset(std::size_t lane) { set(lane, false); }

  bool any() const { return bits_ != 0; }
  bool none() const { return bits_ == 0; }
  std::size_t count() const { return std::bitset<kLanes>(bits_).count(); }

  LaneBits& operator&=(LaneBits other) { return *this = *this & other; }
  LaneBits& operator|=(LaneBits other) { return *this = *this | other; }
  friend LaneBits operator&(LaneBits a, LaneBits b) { return LaneBits(unsigned{a.bits_} & b.bits_); }
  friend LaneBits operator|(LaneBits a, LaneBits b) { return LaneBits(unsigned{a.bits_} | b.bits_); }
  friend LaneBits operator~(LaneBits a) { return LaneBits(~unsigned{a.bits_}); }
  friend bool operator==(LaneBits a, LaneBits b) { return a.bits_ == b.bits_; }
  friend bool operator!=(LaneBits a, LaneBits b) { return a.bits_ != b.bits_; }

 private:
  std::uint8_t bits_ = 0;
};

static_assert(kLanes == 8, "a byte has eight bits");

}  // namespace polhode
