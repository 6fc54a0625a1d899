#include "viewer/model/session.h"

#include <stdexcept>
#include <utility>

#include "scenario/number_text.h"
#include "scenario/printable_text.h"

namespace polhode::demos {

Session::Session(const Scenario& scenario, std::vector<Contender> contenders, std::size_t history_capacity)
    : contenders_(std::move(contenders)),
      history_capacity_(history_capacity),
      simulation_(std::make_unique<Simulation>(scenario, contenders_, history_capacity)) {}

Session::Session(Recording recording, std::size_t history_capacity)
    : Session(recording.scenario, recording.contenders, history_capacity) {
  replayed_ = std::move(recording);
  check_shown_step(*replayed_, *simulation_);
}

void Session::apply(Action action) {
  switch (action) {
    case Action::run_or_pause:
      return run_or_pause();
    case Action::step:
      return step_once();
    case Action::step_back:
      return step_back();
    case Action::reset:
      return reset("started over");
    case Action::faster:
      return clock_.faster();
    case Action::slower:
      return clock_.slower();
  }
}

void Session::advance(double real_s, std::chrono::nanoseconds budget) {
  is_late_ = false;
  if (!is_running_) return;
  const auto deadline = std::chrono::steady_clock::now() + budget;
  for (std::int64_t due = clock_.steps_due(real_s, simulation_->scenario().dt); due > 0; --due) {
    try {
      const std::vector<std::string> diverged = step_simulation();
      if (!diverged.empty()) {
        is_running_ = false;
        return note_divergence(diverged, "paused; Space continues");
      }
    } catch (const std::runtime_error& error) {
      is_running_ = false;
      notice_ = error.what();
      return;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      is_late_ = due > 1;
      return;
    }
  }
}

void Session::run_to(std::int64_t step) {
  while (simulation_->shown_step() < step) {
    const std::string before = notice_;
    note_divergence(step_simulation(), "");
    if (notice_ != before && !before.empty()) notice_ = before + "; " + notice_;
  }
}

void Session::restart(const Scenario& scenario, const std::vector<Contender>& contenders,
                      const std::string& reason) {
  try {
    auto simulation = std::make_unique<Simulation>(scenario, contenders, history_capacity_);
    simulation_ = std::move(simulation);
    contenders_ = contenders;
    replayed_.reset();
    ++generation_;
    clock_.restart();
    notice_ = reason;
  } catch (const std::invalid_argument& error) {
    notice_ = std::string("not changed: ") + error.what();
  }
}

void Session::change_scenario(const Scenario& scenario) {
  ChosenContenders chosen = those_that_can_run(contenders_, scenario);
  if (chosen.contenders.empty()) chosen = chosen_contenders({}, scenario);
  const std::string note = chosen.note.empty() ? "" : "; " + chosen.note;
  restart(scenario, chosen.contenders, scenario.name + " from its start" + note);
}

std::string Session::notice() const {
  constexpr std::size_t kLongest = 1000;  // wider than any window
  return printable(shortened(notice_, kLongest));
}

void Session::run_or_pause() {
  is_running_ = !is_running_;
  clock_.restart();
  notice_.clear();
  if (is_running_ && simulation_->all_diverged() &&
      simulation_->shown_step() == simulation_->computed_step()) {
    is_running_ = false;
    notice_ = "every contender has diverged: R starts over";
  }
}

void Session::step_once() {
  is_running_ = false;
  notice_.clear();
  try {
    note_divergence(step_simulation(), "");
  } catch (const std::runtime_error& error) {
    notice_ = error.what();
  }
}

void Session::step_back() {
  is_running_ = false;
  notice_.clear();
  if (simulation_->step_back()) return;
  notice_ = simulation_->shown_step() == 0
                ? "this is the start"
                : "older steps are not kept (" +
                      number_text(static_cast<std::int64_t>(simulation_->history_capacity())) +
                      " are): R starts over";
}

void Session::reset(const std::string& reason) {
  is_running_ = false;
  std::optional<Recording> replayed = std::move(replayed_);
  restart(simulation_->scenario(), contenders_, reason);
  replayed_ = std::move(replayed);
}

std::vector<std::string> Session::step_simulation() {
  std::vector<std::string> diverged = simulation_->step();
  if (replayed_) check_shown_step(*replayed_, *simulation_);
  return diverged;
}

void Session::note_divergence(const std::vector<std::string>& names, const std::string& what_now) {
  if (names.empty()) return;
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  text += " diverged at t = " + short_number_text(simulation_->shown_t_s(), 6) + " s";
  if (!what_now.empty()) text += " (" + what_now + ")";
  notice_ = text;
}

}  // namespace polhode::demos
