#pragma once

#include <imgui/imgui.h>

#include "viewer/model/palette.h"

namespace polhode::demos {

/// Dear ImGui, dressed for a light ground, while it lives. Needs a current OpenGL context.
class Gui {
 public:
  Gui();
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
};

ImU32 im_color(Color color, float opacity = 1.0f);

inline constexpr Color kInk{0x20, 0x20, 0x20};
inline constexpr Color kFaintInk{0x70, 0x70, 0x70};
inline constexpr Color kPaper{0xFF, 0xFF, 0xFF};
inline constexpr Color kRule{0xC4, 0xC4, 0xC0};
inline constexpr Color kWarning{0xB0, 0x10, 0x10};

}  // namespace polhode::demos
