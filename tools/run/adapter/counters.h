#pragma once

#include <atomic>

#include "polhode/bullet/incident.h"
#include "run/adapter/adapter.h"

namespace polhode::run {

/// Thread-safe counters: a program may step several worlds on several threads.
struct Counters {
  std::atomic<std::uint64_t> rotated_worlds{0};
  std::atomic<std::uint64_t> worlds_left_to_bullet{0};
  std::atomic<std::uint64_t> steps{0};
  std::atomic<std::uint64_t> most_rigid_bodies{0};
  std::atomic<std::uint64_t> most_multibodies{0};
  std::atomic<std::uint64_t> diverged_bodies{0};
  std::atomic<std::uint64_t> non_finite_bodies{0};

  void count(const Incident& incident) {
    (incident.kind == IncidentKind::scheme_diverged ? diverged_bodies : non_finite_bodies)++;
  }

  Counts read() const {
    Counts counts;
    counts.rotated_worlds = rotated_worlds;
    counts.worlds_left_to_bullet = worlds_left_to_bullet;
    counts.steps = steps;
    counts.most_rigid_bodies = most_rigid_bodies;
    counts.most_multibodies = most_multibodies;
    counts.diverged_bodies = diverged_bodies;
    counts.non_finite_bodies = non_finite_bodies;
    return counts;
  }
};

inline void raise_to(std::atomic<std::uint64_t>& most, std::uint64_t value) {
  std::uint64_t seen = most;
  while (seen < value && !most.compare_exchange_weak(seen, value)) {
  }
}

}  // namespace polhode::run
