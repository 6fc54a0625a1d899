#pragma once

#include <cstddef>
#include <cstdint>

namespace polhode::fuzz {

/// Reads small numbers from a fuzzer's input. Returns 0 bytes past the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool empty() const { return next_ == end_; }
  std::uint8_t byte() { return empty() ? std::uint8_t(0) : *next_++; }
  bool flag() { return (byte() & 1U) != 0; }
  /// Returns a number below `count`.
  std::size_t below(std::size_t count) { return byte() % count; }
  /// Returns a number between -1 and 1.
  double unit() {
    const int number = byte() * 256 + byte();
    return (number - 32768) / 32768.0;
  }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

}  // namespace polhode::fuzz
