#include "viewer/interface/help.h"

#include <imgui/imgui.h>

namespace polhode::demos {

namespace {

struct KeyHelp {
  const char* key;
  const char* meaning;
};

constexpr KeyHelp kKeys[] = {{"Space", "run or pause"},
                             {"Right", "one step"},
                             {"Left", "one step back"},
                             {"R", "start over"},
                             {"+  -", "double or halve the speed"},
                             {"T", "inertia ellipsoid, polhode, herpolhode"},
                             {"P", "controls and plots"},
                             {"F", "follow the bodies"},
                             {"Home", "reset the camera"},
                             {"mouse drag", "turn the camera"},
                             {"mouse wheel", "zoom"},
                             {"F1  H", "this help"},
                             {"Esc", "quit"}};

}  // namespace

void draw_help(float width, float height) {
  ImGui::SetNextWindowPos({0.5f * width, 0.5f * height}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("Keys", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const KeyHelp& key : kKeys) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(key.key);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(key.meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace polhode::demos
