#pragma once

#include <cstdint>

namespace polhode::demos {

/// Tells how many steps are due: real time times a speed factor.
class PlaybackClock {
 public:
  static constexpr double kSlowest = 1.0 / 1024.0;
  static constexpr double kFastest = 1024.0;

  /// Returns the steps due after this much more real time. A fraction of a step is kept for the next call.
  std::int64_t steps_due(double real_s, double dt_s);
  /// Drops the fraction of a step.
  void restart() { owed_s_ = 0.0; }

  double speed() const { return speed_; }
  void set_speed(double speed);
  void faster() { set_speed(2.0 * speed_); }
  void slower() { set_speed(0.5 * speed_); }

 private:
  double speed_ = 1.0;
  double owed_s_ = 0.0;
};

}  // namespace polhode::demos
