#pragma once

#include <LinearMath/btTransform.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "polhode/bullet/snapshot.h"
#include "polhode/rotation_state.h"

/// Writes records to bytes and reads them back. One list of fields serves both directions:
///
///   template <class Archive>
///   void serialize(Archive& archive, Record& record) { archive(record.first, record.second); }
///
/// Numbers are little-endian and have a fixed width; floating-point numbers are finite.
namespace polhode {
inline namespace POLHODE_PRECISION {

[[noreturn]] inline void refuse_snapshot(const std::string& reason) {
  throw std::invalid_argument("this snapshot cannot be restored: " + reason);
}

/// The unsigned integer type of the same size.
template <class Number>
using BitsOf = std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>;

/// The common part of Writer and Reader: splits composite values into their fields.
template <class Direction>
class Archive {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (field(values), ...);
  }

 protected:
  Direction& direction() { return static_cast<Direction&>(*this); }

  template <class Value>
  void field(Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
      direction().number(value);
    } else {
      serialize(direction(), value);
    }
  }
  void field(btVector3& v) { (*this)(v.m_floats[0], v.m_floats[1], v.m_floats[2]); }
  void field(btMatrix3x3& m) { (*this)(m[0], m[1], m[2]); }
  void field(btTransform& pose) { (*this)(pose.getBasis(), pose.getOrigin()); }
  void field(Vector3& v) { (*this)(v.x(), v.y(), v.z()); }
  void field(Quaternion& q) { (*this)(q.w(), q.x(), q.y(), q.z()); }
  template <class Value, std::size_t size>
  void field(std::array<Value, size>& values) {
    for (Value& value : values) field(value);
  }
  template <class Value>
  void field(std::vector<Value>& values) {
    direction().resize(values);
    for (Value& value : values) field(value);
  }
  template <class Value>
  void field(std::optional<Value>& value) {
    bool has_value = value.has_value();
    field(has_value);
    if (!has_value) return;
    if (!value.has_value()) value.emplace();
    field(*value);
  }
  void field(std::string& text) {
    direction().resize(text);
    for (char& character : text) field(character);
  }
};

class Writer : public Archive<Writer> {
 public:
  /// Appends to `bytes`. The size of `bytes` is correct only after the writer is destroyed.
  explicit Writer(Snapshot& bytes) : bytes_(bytes), used_(bytes.size()) {}
  ~Writer() { bytes_.resize(used_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

 private:
  friend class Archive<Writer>;

  template <class Number>
  void number(const Number& value) {
    static_assert(sizeof(Number) == 1 || sizeof(Number) == 4 || sizeof(Number) == 8);
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value)) {
        throw std::invalid_argument(
            "a body, contact or joint has a number that is not finite and cannot be saved: set it to a "
            "finite "
            "number, or take a step, which does so for the bodies that the library rotates");
      }
    }
    BitsOf<Number> bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    if (bytes_.size() - used_ < sizeof bits) bytes_.resize(2 * bytes_.size() + kFirstBytes);
    std::byte* const next = bytes_.data() + used_;
    for (std::size_t i = 0; i < sizeof bits; ++i) next[i] = static_cast<std::byte>(bits >> (8 * i) & 0xff);
    used_ += sizeof bits;
  }
  template <class List>
  void resize(const List& list) {
    number(static_cast<std::uint32_t>(list.size()));
  }

  static constexpr std::size_t kFirstBytes = 1024;

  Snapshot& bytes_;
  std::size_t used_;  ///< bytes written; the rest of bytes_ is spare
};

/// Throws std::invalid_argument if the bytes are not a valid record.
class Reader : public Archive<Reader> {
 public:
  Reader(const std::byte* first, const std::byte* end) : next_(first), end_(end) {}

  void require_end() const {
    if (next_ != end_) refuse_snapshot("it is longer than its contents");
  }

 private:
  friend class Archive<Reader>;

  std::size_t left() const { return static_cast<std::size_t>(end_ - next_); }

  template <class Number>
  void number(Number& value) {
    BitsOf<Number> bits = 0;
    if (left() < sizeof bits) refuse_snapshot("it is shorter than its contents");
    for (std::size_t i = 0; i < sizeof bits; ++i) {
      bits = static_cast<BitsOf<Number>>(bits | static_cast<BitsOf<Number>>(*next_++) << (8 * i));
    }
    if constexpr (std::is_same_v<Number, bool>) {
      if (bits > 1) refuse_snapshot("it holds a boolean that is neither 0 nor 1");
      value = bits != 0;
    } else {
      std::memcpy(&value, &bits, sizeof value);
    }
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value)) refuse_snapshot("it holds a number that is not finite");
    }
  }
  template <class List>
  void resize(List& list) {
    std::uint32_t size = 0;
    number(size);
    // An element takes at least one byte, so a false size cannot allocate too much memory.
    if (size > left()) refuse_snapshot("it is shorter than its contents");
    list.resize(size);
  }

  const std::byte* next_;
  const std::byte* end_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
