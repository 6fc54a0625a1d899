#pragma once

#include <cstdint>
#include <set>
#include <thread>
#include <tuple>
#include <vector>

#include "multithreading/mt_scene.h"
#include "multithreading/schedulers.h"

namespace polhode::testing {

inline constexpr int kSteps = POLHODE_MULTITHREADING_STEPS;

/// An incident as passed to the handler.
struct ToldIncident {
  int step;
  IncidentKind kind;
  std::size_t body;
  std::uint64_t body_steps;

  bool operator==(const ToldIncident& other) const {
    return std::tie(step, kind, body, body_steps) ==
           std::tie(other.step, other.kind, other.body, other.body_steps);
  }
};

/// The result of a run.
struct Outcome {
  std::vector<std::uint64_t> digests;  ///< after each step
  std::vector<ToldIncident> incidents;
  std::set<std::thread::id> threads_of_handler;
  std::uint64_t counted_incidents = 0;
  int contacts_at_end = 0;  ///< touching or nearly touching pairs of bodies
};

/// A simulation: its bodies, and the application's changes before each step.
struct Play {
  void (*set_up)(MtScene& scene);
  void (*act)(MtScene& scene, int step);
  btScalar dt;
  int steps;
};

/// Runs the play with one scheduler. The incident handler sets `exact` for every other diverged body.
Outcome run(const Play& play, Way way, BulletParts parts, const SchedulerChoice& scheduler);

/// Returns the first step that differs, counted from 1; 0 if there is none.
int first_step_that_differs(const Outcome& a, const Outcome& b);

}  // namespace polhode::testing
