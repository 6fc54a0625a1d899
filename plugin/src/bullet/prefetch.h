#pragma once

#include <cstddef>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Asks for what a loop will need a few bodies later: Bullet's bodies, their boxes and motion states are
/// scattered, and each is some lines of the cache. From `first` to before `end`.
inline void prefetch(const void* first, const void* end) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64;
  for (const char* at = static_cast<const char*>(first); at < end; at += kLine) __builtin_prefetch(at);
#endif
}

/// An object as it is declared; what it is derived into comes after.
template <class Object>
void prefetch(const Object& object) {
  prefetch(&object, &object + 1);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
