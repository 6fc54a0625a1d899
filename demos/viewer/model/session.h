#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "viewer/model/playback_clock.h"
#include "viewer/model/recording.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

/// The actions of keys and buttons.
enum class Action { run_or_pause, step, step_back, reset, faster, slower };

/// Handles a user's actions on a simulation: play, pause, step, start over, change. notice() is a message to
/// the user.
class Session {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses
  Session(const Scenario& scenario, std::vector<Contender> contenders,
          std::size_t history_capacity = kHistoryCapacity);

  /// Runs a recording again. Pauses at a step that differs from the recording and says so in the notice.
  explicit Session(Recording recording, std::size_t history_capacity = kHistoryCapacity);

  void apply(Action action);

  /// Plays for this much real time, but computes no longer than `budget`; if that is too short, playback is
  /// slower than asked for and is_late() returns true. Pauses at a divergence.
  void advance(double real_s, std::chrono::nanoseconds budget);
  /// Runs to this step without pausing at a divergence. The notice names the contenders that diverge on the
  /// way.
  /// @throws std::runtime_error if a replay differs from its recording
  void run_to(std::int64_t step);

  /// Starts over with these changes and ends a replay. If they cannot be run, nothing changes and the notice
  /// says why.
  void restart(const Scenario& scenario, const std::vector<Contender>& contenders, const std::string& reason);

  /// Starts over with another scenario and those contenders that can run it, or the default ones if none can.
  void change_scenario(const Scenario& scenario);

  const Simulation& simulation() const { return *simulation_; }
  /// Returns the number of steps of the recording being replayed, 0 without one.
  std::int64_t replayed_steps() const { return replayed_ ? replayed_->steps() : 0; }
  const std::vector<Contender>& contenders() const { return contenders_; }
  PlaybackClock& clock() { return clock_; }
  const PlaybackClock& clock() const { return clock_; }
  bool is_running() const { return is_running_; }
  bool is_late() const { return is_late_; }
  /// Returns how often the simulation was created anew.
  int generation() const { return generation_; }
  /// Returns one printable line.
  std::string notice() const;
  void set_notice(std::string text) { notice_ = std::move(text); }

 private:
  std::vector<std::string> step_simulation();
  void run_or_pause();
  void step_once();
  void step_back();
  void reset(const std::string& reason);
  void note_divergence(const std::vector<std::string>& names, const std::string& what_now);

  std::vector<Contender> contenders_;
  std::size_t history_capacity_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<Recording> replayed_;
  PlaybackClock clock_;
  bool is_running_ = false;
  bool is_late_ = false;
  int generation_ = 0;
  std::string notice_;
};

}  // namespace polhode::demos
