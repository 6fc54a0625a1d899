#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace polhode {

/// Room for what a scheme computed for one body and may use again in its next step. Whoever holds a body's
/// state holds one beside it; nobody but the scheme looks inside. A scheme must check that what it finds
/// still fits the state and the step it is given: nobody tells it of changes. The bodies of a scheme that
/// declares `rotation: lost` have none that lasts: their matrix is kept in its place.
class SchemeMemory {
 public:
  static constexpr std::size_t kBytes = 176;

  /// The T that is kept here; T() if it is another type's or nobody's.
  template <class T>
  T& get() noexcept {
    static_assert(std::is_trivially_copyable_v<T>, "a body's memory is copied byte by byte");
    static_assert(sizeof(T) <= kBytes, "it does not fit");
    static_assert(alignof(T) <= alignof(double), "it does not fit");
    if (type_ != &kTypeOf<T>) {
      type_ = &kTypeOf<T>;
      return *new (bytes_) T();
    }
    return *std::launder(reinterpret_cast<T*>(bytes_));
  }

  /// The T that is kept here; null if it is another type's or nobody's.
  template <class T>
  const T* find() const noexcept {
    return type_ == &kTypeOf<T> ? std::launder(reinterpret_cast<const T*>(bytes_)) : nullptr;
  }

 private:
  template <class T>
  static constexpr char kTypeOf = 0;  // its address tells types apart

  const char* type_ = nullptr;
  alignas(double) std::byte bytes_[kBytes];
};

}  // namespace polhode
