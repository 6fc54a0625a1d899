#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "viewer/model/camera.h"
#include "viewer/model/changes.h"

namespace polhode::demos {

/// Holds how a user looks at a session; nothing in it changes what is computed.
struct ViewState {
  OrbitCamera camera;
  bool is_teaching = false;
  bool has_panels = true;
  bool has_help = false;
  bool follows_bodies = false;
  /// The fields of the control panel, which count once they are applied.
  Changes edited{};
  std::array<char, 256> csv_file{"polhode.csv"};
  std::array<char, 256> png_file{"polhode.png"};
  std::array<char, 256> recording_file{"polhode_run.txt"};
  /// The next picture is to be written there.
  std::optional<std::filesystem::path> wanted_png;
};

}  // namespace polhode::demos
