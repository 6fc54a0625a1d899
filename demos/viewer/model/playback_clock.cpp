#include "viewer/model/playback_clock.h"

#include <algorithm>
#include <cmath>

namespace polhode::demos {

namespace {

/// After an interruption playback continues where it was instead of catching up.
constexpr double kLongestFrame = 0.1;  // s

}  // namespace

std::int64_t PlaybackClock::steps_due(double real_s, double dt_s) {
  owed_s_ += std::clamp(real_s, 0.0, kLongestFrame) * speed_;
  const double steps = std::floor(owed_s_ / dt_s);
  owed_s_ = std::max(0.0, owed_s_ - steps * dt_s);
  return static_cast<std::int64_t>(steps);
}

void PlaybackClock::set_speed(double speed) {
  speed_ = std::clamp(speed, kSlowest, kFastest);
}

}  // namespace polhode::demos
