#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "viewer/model/camera.h"
#include "viewer/model/changes.h"

namespace polhode::demos {

/// How a user looks at a session; does not affect the computation.
struct ViewState {
  OrbitCamera camera;
  bool is_teaching = false;
  bool has_panels = true;
  bool has_help = false;
  bool follows_bodies = false;
  /// The fields of the control panel, used once they are applied.
  Changes edited{};
  std::array<char, 256> csv_file{"polhode.csv"};
  std::array<char, 256> png_file{"polhode.png"};
  std::array<char, 256> recording_file{"polhode_run.txt"};
  /// File for the next picture.
  std::optional<std::filesystem::path> wanted_png;
};

}  // namespace polhode::demos
