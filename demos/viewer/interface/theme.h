#pragma once

#include <imgui/imgui.h>

#include "viewer/model/palette.h"

namespace polhode::demos {

/// Dear ImGui with a light theme, during its lifetime. Needs a current OpenGL context.
class Gui {
 public:
  /// Texts are `scale` times as large as on a usual screen, in units of `pixels` pixels.
  explicit Gui(float scale = 1.0f, float pixels = 1.0f);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
};

inline constexpr float kFontSize = 15.0f;

/// Returns a length scaled like the texts.
inline float scaled(float length) {
  return length * ImGui::GetFontSize() / kFontSize;
}

ImU32 im_color(Color color, float opacity = 1.0f);

inline constexpr Color kInk{0x20, 0x20, 0x20};
inline constexpr Color kFaintInk{0x70, 0x70, 0x70};
inline constexpr Color kPaper{0xFF, 0xFF, 0xFF};
inline constexpr Color kRule{0xC4, 0xC4, 0xC0};
inline constexpr Color kWarning{0xB0, 0x10, 0x10};

}  // namespace polhode::demos
