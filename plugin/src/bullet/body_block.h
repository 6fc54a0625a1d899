#pragma once

#include <array>
#include <bitset>
#include <cstddef>

#include "bullet/managed_body.h"
#include "lanes/lanes.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bodies that wait until there are eight.
struct BodyBlock {
  std::array<ManagedBody*, kLanes> bodies;
  std::size_t count = 0;

  bool is_full() const { return count == kLanes; }
  void add(ManagedBody& body) {
    bodies[count] = &body;
    ++count;
  }
};

using BlockLanes = std::bitset<kLanes>;

/// Bodies on their way into full blocks of those that nobody has touched.
class WaitingBodies {
 public:
  /// `together(block)` does what there is to do, if it can do it for all eight; it returns those it could do
  /// it for, which are then gathered once more, so that one body does not keep seven others from going
  /// together. `alone(body)` does it for one.
  template <class Together, class Alone>
  void add(ManagedBody& body, Together together, Alone alone) {
    maybe_untouched_.add(body);
    if (!maybe_untouched_.is_full()) return;
    const BlockLanes untouched = together(maybe_untouched_);
    maybe_untouched_.count = 0;
    if (untouched.all()) return;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      ManagedBody& of_lane = *maybe_untouched_.bodies[lane];
      if (untouched[lane]) {
        add_untouched(of_lane, together);
      } else {
        alone(of_lane);
      }
    }
  }

  /// Of less than eight bodies each goes alone.
  template <class Alone>
  void complete(Alone alone) {
    for (BodyBlock* block : {&maybe_untouched_, &untouched_}) {
      for (std::size_t i = 0; i < block->count; ++i) alone(*block->bodies[i]);
      block->count = 0;
    }
  }

 private:
  template <class Together>
  void add_untouched(ManagedBody& body, Together together) {
    untouched_.add(body);
    if (!untouched_.is_full()) return;
    together(untouched_);
    untouched_.count = 0;
  }

  BodyBlock maybe_untouched_;
  BodyBlock untouched_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
