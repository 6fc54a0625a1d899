#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "viewer/model/simulation.h"

/// A run in a file: its start, and for each step a digest of each contender's whole state. A replay computes
/// the run again and compares the digests.
namespace polhode::demos {

struct Recording {
  Scenario scenario;
  std::vector<Contender> contenders;
  /// The digests of each step, the start included, one for each contender; 0 after it diverged.
  std::vector<std::vector<std::uint64_t>> digests;

  std::int64_t steps() const { return static_cast<std::int64_t>(digests.size()) - 1; }
};

/// Writes the run up to the step shown.
/// @throws std::runtime_error if the file cannot be written, or the run is too long to have been kept
void write_recording(const Simulation& simulation, const std::filesystem::path& file);

/// Reads a recording. Keeps the digests in memory, and of the file one line at a time.
/// @throws std::invalid_argument or ScenarioError that says what is wrong with the file
Recording read_recording(const std::filesystem::path& file);

/// Compares the step shown with the recording. Steps after the recording's end are not checked.
/// @throws std::runtime_error that names step and contender at a difference
void check_shown_step(const Recording& recording, const Simulation& simulation);

}  // namespace polhode::demos
