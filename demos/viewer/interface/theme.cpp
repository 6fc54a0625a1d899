#include "viewer/interface/theme.h"

#include <imgui/backends/imgui_impl_opengl3.h>

#include <cmath>
#include <stdexcept>

namespace polhode::demos {

Gui::Gui() {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.FrameRounding = 2.0f;
  style.FrameBorderSize = 1.0f;
  style.WindowBorderSize = 0.0f;
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
