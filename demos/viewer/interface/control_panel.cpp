#include "viewer/interface/control_panel.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scenario/printable_text.h"
#include "scenario/scenario_directory.h"
#include "viewer/interface/theme.h"
#include "viewer/model/csv_export.h"
#include "world/body_shape.h"

namespace polhode::demos {

namespace {

/// Calls the function and puts an error into the notice.
template <typename Work>
void attempt(Session& session, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    session.set_notice(error.what());
  }
}

void draw_playback(Session& session) {
  if (ImGui::Button(session.is_running() ? "Pause" : "Run", {scaled(62.0f), 0.0f})) {
    session.apply(Action::run_or_pause);
  }
  ImGui::SameLine();
  if (ImGui::Button("Start over")) session.apply(Action::reset);
  ImGui::SameLine();
  if (ImGui::Button("< step")) session.apply(Action::step_back);
  ImGui::SameLine();
  if (ImGui::Button("step >")) session.apply(Action::step);
  if (ImGui::Button("slower")) session.apply(Action::slower);
  ImGui::SameLine();
  if (ImGui::Button("faster")) session.apply(Action::faster);
  ImGui::SameLine();
  ImGui::Text("speed x%g", session.clock().speed());
}

void draw_scenarios(Session& session) {
  const std::string current = session.simulation().scenario().name;  // a copy: its owner may be replaced
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##scenario", current.c_str())) return;
  attempt(session, [&] {
    for (const std::string& name : scenario_names()) {
      if (!ImGui::Selectable(printable(name).c_str(), name == current)) continue;
      session.change_scenario(resolved(find_scenario(name)));
    }
  });
  ImGui::EndCombo();
}

std::size_t index_of(const std::vector<Contender>& contenders, const std::string& name) {
  const auto found = std::find_if(contenders.begin(), contenders.end(),
                                  [&](const Contender& contender) { return contender.name == name; });
  return static_cast<std::size_t>(found - contenders.begin());
}

void toggle(Session& session, const Contender& contender) {
  std::vector<Contender> chosen = session.contenders();
  const std::size_t index = index_of(chosen, contender.name);
  if (index == chosen.size()) {
    chosen.push_back(contender);
  } else if (chosen.size() > 1) {
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(index));
  }
  session.restart(session.simulation().scenario(), chosen, "other contenders: started over");
}

void draw_contenders(Session& session) {
  static const std::vector<Contender> all = all_contenders();
  for (const Contender& contender : all) {
    const std::size_t index = index_of(session.contenders(), contender.name);
    bool is_chosen = index < session.contenders().size();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (is_chosen) {
      const float size = scaled(13.0f);
      const float top = at.y + 0.5f * (ImGui::GetFrameHeight() - size);
      ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + size, top + size},
                                                im_color(contender_color(index)));
    }
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + scaled(20.0f));
    if (ImGui::Checkbox(contender.name.c_str(), &is_chosen)) toggle(session, contender);
  }
}

void input_vector(const char* label, Vector3& vector) {
  ImGui::TextUnformatted(label);
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::PushID(label);
  ImGui::InputScalarN("##vector", ImGuiDataType_Double, vector.data(), 3, nullptr, nullptr, "%.6g");
  ImGui::PopID();
}

void draw_changes(Session& session, ViewState& view) {
  ImGui::TextUnformatted("time step, s");
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputDouble("##dt", &view.edited.dt, 0.0, 0.0, "%.6g");
  input_vector("moments of inertia, kg m^2", view.edited.inertia_B);
  input_vector("angular velocity at the start, rad/s", view.edited.omega_W);
  if (ImGui::Button("Apply and start over")) {
    attempt(session, [&] {
      session.restart(changed(session.simulation().scenario(), view.edited), session.contenders(),
                      "changed: started over");
    });
  }
  ImGui::SameLine();
  if (ImGui::Button("Undo")) view.edited = changes_of(session.simulation().scenario());
}

/// Draws a field for a file's name with a button. Returns true if the button is pressed.
bool file_button(std::array<char, 256>& file, const char* button) {
  ImGui::PushID(button);
  ImGui::SetNextItemWidth(scaled(190.0f));
  ImGui::InputText("##file", file.data(), file.size());
  ImGui::SameLine();
  const bool is_pressed = ImGui::Button(button);
  ImGui::PopID();
  return is_pressed;
}

void draw_export(Session& session, ViewState& view) {
  if (file_button(view.csv_file, "Write CSV")) {
    attempt(session, [&] {
      export_csv(session.simulation(), view.csv_file.data());
      session.set_notice(std::string("written: ") + view.csv_file.data());
    });
  }
  if (file_button(view.png_file, "Write PNG")) view.wanted_png = view.png_file.data();
  if (file_button(view.recording_file, "Record")) {
    attempt(session, [&] {
      write_recording(session.simulation(), view.recording_file.data());
      session.set_notice(std::string("written: ") + view.recording_file.data());
    });
  }
}

}  // namespace

void draw_control_panel(Session& session, ViewState& view, const Rectangle& area) {
  ImGui::SetNextWindowPos({area.left, area.top});
  ImGui::SetNextWindowSize({area.width, area.height});
  ImGui::Begin("controls", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  ImGui::TextUnformatted("Scenario");
  draw_scenarios(session);
  ImGui::TextWrapped("%s", session.simulation().scenario().description.c_str());
  ImGui::Separator();
  draw_playback(session);
  ImGui::Checkbox("ellipsoid, polhode, herpolhode (T)", &view.is_teaching);
  ImGui::Checkbox("camera follows the bodies (F)", &view.follows_bodies);
  ImGui::Separator();
  ImGui::TextUnformatted("Contenders (a change starts over)");
  draw_contenders(session);
  ImGui::Separator();
  draw_changes(session, view);
  ImGui::Separator();
  ImGui::TextUnformatted("Export");
  draw_export(session, view);
  ImGui::End();
}

}  // namespace polhode::demos
