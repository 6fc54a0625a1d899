#pragma once

#include <array>
#include <cstddef>

#include "free_top/free_top_step.h"
#include "lanes/lanes.h"
#include "polhode/rotation_scheme.h"

namespace polhode::free_top {

/// Up to eight bodies from any places of a step_bodies, each with its FreeTopStep, and the way from there to
/// lanes. With fewer than eight, the last one fills the lanes that are left.
class LaneBodies {
 public:
  bool is_empty() const { return count_ == 0; }
  bool is_full() const { return count_ == kLanes; }
  std::size_t count() const { return count_; }
  const BodyStep& body(std::size_t lane) const { return bodies_[lane]; }
  FreeTopStep& step(std::size_t lane) const { return *steps_[lane]; }

  void clear() { count_ = 0; }
  void add(const BodyStep& body, FreeTopStep& step) {
    bodies_[count_] = body;
    steps_[count_] = &step;
    ++count_;
  }
  /// To be called before anything is gathered.
  void fill_up() {
    for (std::size_t lane = count_; lane < kLanes; ++lane) {
      bodies_[lane] = bodies_[count_ - 1];
      steps_[lane] = steps_[count_ - 1];
    }
  }

  // A member of each body's input, state, FreeTopStep or its constants, in lanes.
  POLHODE_INLINE Lanes of_input(double StepInput::*member) const {
    return gather([&](std::size_t lane) { return bodies_[lane].input->*member; });
  }
  POLHODE_INLINE Vector3L of_input(Vector3 StepInput::*member) const {
    return vector(gather<3>([&](std::size_t lane) -> auto& { return bodies_[lane].input->*member; }));
  }
  POLHODE_INLINE Vector3L of_state(Vector3 RotationState::*member) const {
    return vector(gather<3>([&](std::size_t lane) -> auto& { return bodies_[lane].state->*member; }));
  }
  POLHODE_INLINE QuaternionL of_state(Quaternion RotationState::*member) const {
    const auto coeffs =
        gather<4>([&](std::size_t lane) -> auto& { return (bodies_[lane].state->*member).coeffs(); });
    return {coeffs[3], coeffs[0], coeffs[1], coeffs[2]};
  }
  POLHODE_INLINE Triple<Lanes> of_step(Triple<double> FreeTopStep::*member) const {
    return gather<3>([&](std::size_t lane) -> auto& { return steps_[lane]->*member; });
  }
  POLHODE_INLINE Axes<Lanes> axes() const {
    return gather<3>([&](std::size_t lane) -> auto& { return steps_[lane]->axes; });
  }
  POLHODE_INLINE Substep<Lanes> substep() const {
    return {of_substep(&Substep<double>::mu),      of_substep(&Substep<double>::cn),
            of_substep(&Substep<double>::dn),      of_substep(&Substep<double>::slope),
            of_substep(&Substep<double>::pull_12), of_substep(&Substep<double>::pull_23)};
  }

 private:
  POLHODE_INLINE Lanes of_substep(double Substep<double>::*member) const {
    return gather([&](std::size_t lane) { return steps_[lane]->substep.*member; });
  }
  template <std::size_t size>
  POLHODE_INLINE std::array<Lanes, size> of_substep(std::array<double, size> Substep<double>::*member) const {
    return gather<size>([&](std::size_t lane) -> auto& { return steps_[lane]->substep.*member; });
  }

  // `get(lane)` is a number.
  template <class Get>
  static POLHODE_INLINE Lanes gather(Get get) {
    Lanes result;
    for (std::size_t lane = 0; lane < kLanes; ++lane) result.set(lane, get(lane));
    return result;
  }
  // `get(lane)` has so many numbers.
  template <std::size_t size, class Get>
  static POLHODE_INLINE std::array<Lanes, size> gather(Get get) {
    std::array<Lanes, size> result;
    for (std::size_t i = 0; i < size; ++i) {
      result[i] = gather([&](std::size_t lane) -> double { return get(lane)[i]; });
    }
    return result;
  }
  static POLHODE_INLINE Vector3L vector(const std::array<Lanes, 3>& v) { return {v[0], v[1], v[2]}; }

  std::array<BodyStep, kLanes> bodies_;
  std::array<FreeTopStep*, kLanes> steps_;
  std::size_t count_ = 0;
};

}  // namespace polhode::free_top
