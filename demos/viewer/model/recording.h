#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "viewer/model/simulation.h"

/// A run in a file: its start, and for each step of each contender a digest of all bits of its state. A
/// replay computes the run again and compares the digests.
namespace polhode::demos {

struct Recording {
  Scenario scenario;
  std::vector<Contender> contenders;
  /// The digests of each step, the start included, one for each contender; 0 once it has diverged.
  std::vector<std::vector<std::uint64_t>> digests;

  std::int64_t steps() const { return static_cast<std::int64_t>(digests.size()) - 1; }
};

/// The run up to the step that is shown.
/// @throws std::runtime_error if the file cannot be written, or the run is too long to have been kept.
void write_recording(const Simulation& simulation, const std::filesystem::path& file);

/// Holds the digests in memory, of the file one line at a time.
/// @throws std::invalid_argument or ScenarioError, which say what is wrong with the file
Recording read_recording(const std::filesystem::path& file);

/// Steps after the recording's end are free.
/// @throws std::runtime_error that names step and contender if what is shown is not what was recorded
void check_shown_step(const Recording& recording, const Simulation& simulation);

}  // namespace polhode::demos
