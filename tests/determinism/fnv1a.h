#pragma once

#include <cstddef>
#include <cstdint>

namespace polhode::testing {

/// The 64-bit FNV-1a hash of bytes (http://www.isthe.com/chongo/tech/comp/fnv/).
class Fnv1a {
 public:
  std::uint64_t value() const { return value_; }

  void add_bytes(const void* bytes, std::size_t count) {
    const auto* const first = static_cast<const unsigned char*>(bytes);
    for (const unsigned char* byte = first; byte != first + count; ++byte) {
      value_ = (value_ ^ *byte) * 0x100000001b3u;
    }
  }

  template <class Number>
  void add(Number number) {
    add_bytes(&number, sizeof number);
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace polhode::testing
