#include "viewer/interface/theme.h"

#include <imgui/backends/imgui_impl_opengl3.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "viewer/interface/font_file.h"

namespace polhode::demos {

namespace {

/// Western letters, Greek, subscripts, the minus sign: the characters of the font file.
constexpr ImWchar kGlyphs[] = {0x20, 0xFF, 0x391, 0x3C9, 0x2070, 0x209C, 0x2212, 0x2212, 0};

void load_font(float size, float pixels) {
  const std::string_view file = font_file();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  ImGuiIO& io = ImGui::GetIO();
  // Drawn in the screen's pixels, sized in its units.
  io.Fonts->AddFontFromMemoryTTF(const_cast<char*>(file.data()), static_cast<int>(file.size()), size * pixels,
                                 &config, kGlyphs);
  io.FontGlobalScale = 1.0f / pixels;
}

}  // namespace

Gui::Gui(float scale, float pixels) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // writes no settings file
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.FrameRounding = 2.0f;
  style.FrameBorderSize = 1.0f;
  style.WindowBorderSize = 0.0f;
  style.WindowPadding = {10.0f, 10.0f};
  style.FramePadding = {6.0f, 3.0f};
  style.ItemSpacing = {8.0f, 5.0f};
  style.ScaleAllSizes(scale);
  load_font(kFontSize * scale, pixels);
  if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
    ImGui::DestroyContext();
    throw std::runtime_error("Dear ImGui finds no OpenGL 3.3");
  }
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

ImU32 im_color(Color color, float opacity) {
  return IM_COL32(color.red, color.green, color.blue, static_cast<int>(std::lround(255.0f * opacity)));
}

}  // namespace polhode::demos
