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

/// Does what a user asks of a simulation: plays, pauses, steps, starts over, changes it. notice() tells the
/// user about it.
class Session {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses.
  Session(const Scenario& scenario, std::vector<Contender> contenders,
          std::size_t history_capacity = kHistoryCapacity);

  /// Runs a recording again. A step that is not the recorded one pauses, and is in the notice.
  explicit Session(Recording recording, std::size_t history_capacity = kHistoryCapacity);

  void apply(Action action);

  /// Plays on for so much real time, but computes for no longer than `budget`: then playback is slower than
  /// asked for, which is_late() says. A divergence pauses.
  void advance(double real_s, std::chrono::nanoseconds budget);
  /// Runs to that step without a pause at a divergence. The notice names the contenders that diverge on the
  /// way.
  /// @throws std::runtime_error where a replay leaves its recording
  void run_to(std::int64_t step);

  /// Starts over with these; that is no replay any more. Where they cannot be run, all stays as it was and
  /// the notice says why.
  void restart(const Scenario& scenario, const std::vector<Contender>& contenders, const std::string& reason);

  /// Starts over with another scenario and those of the contenders that can run it; with the default ones if none can.
  void change_scenario(const Scenario& scenario);

  const Simulation& simulation() const { return *simulation_; }
  /// Returns the number of steps of the recording that is replayed, 0 without one.
  std::int64_t replayed_steps() const { return replayed_ ? replayed_->steps() : 0; }
  const std::vector<Contender>& contenders() const { return contenders_; }
  PlaybackClock& clock() { return clock_; }
  const PlaybackClock& clock() const { return clock_; }
  bool is_running() const { return is_running_; }
  bool is_late() const { return is_late_; }
  /// Counts how often the simulation was made anew.
  int generation() const { return generation_; }
  /// One printable line.
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
