#include "viewer/interface/labels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "record/errors.h"
#include "scenario/number_text.h"
#include "viewer/interface/theme.h"

namespace polhode::demos {

namespace {

constexpr float kMargin = 8.0f;
constexpr float kChip = 13.0f;
constexpr float kLine = 16.0f;
constexpr float kStatusLine = 24.0f;
constexpr char kHelpHint[] = "H: keys";
/// The name of a shorter arrow would hide it.
constexpr double kShortestNamed = 0.08;

void write(float left, float top, Color color, const std::string& text) {
  ImGui::GetBackgroundDrawList()->AddText({left, top}, im_color(color), text.c_str());
}

/// On a light ground, since it may lie over a body.
void write_on_paper(float left, float top, Color color, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      {left - 2.0f, top - 1.0f}, {left + size.x + 2.0f, top + size.y + 1.0f}, im_color(kPaper, 0.75f));
  write(left, top, color, text);
}

/// Between the texts at the top and at the bottom of a view; below others that it would lie on, or right of
/// them where there is no room below.
Rectangle place(Rectangle label, const Rectangle& free, const std::vector<Rectangle>& others) {
  const float lowest = free.top + free.height - label.height;
  label.top = std::max(free.top, std::min(label.top, lowest));
  for (const Rectangle& other : others) {
    const bool is_apart = label.left >= other.left + other.width || other.left >= label.left + label.width ||
                          label.top >= other.top + other.height || other.top >= label.top + label.height;
    if (is_apart) continue;
    if (other.top + other.height <= lowest) {
      label.top = other.top + other.height;
    } else {
      label.left = other.left + other.width;
    }
  }
  return label;
}

void draw_arrow_names(const Simulation& simulation, const Scene& scene, const OrbitCamera& camera,
                      bool is_teaching, const Rectangle& viewport, const Rectangle& free, std::size_t index) {
  const Matrix4f view_projection = camera.projection(viewport.width / viewport.height) * camera.view();
  std::vector<Rectangle> placed;
  for (const Arrow& arrow : scene.arrows(simulation, index, is_teaching)) {
    if (arrow.along_W.norm() < kShortestNamed * scene.radius()) continue;
    Eigen::Vector2f pixel;
    const Vector3 tip_W = arrow.from_W + 1.08 * arrow.along_W;
    if (!project(view_projection, tip_W, {viewport.width, viewport.height}, pixel)) continue;
    const ImVec2 size = ImGui::CalcTextSize(arrow.name);
    const Rectangle wanted{viewport.left + pixel.x() - 0.5f * size.x,
                           viewport.top + pixel.y() - 0.5f * size.y, size.x + 4.0f, size.y + 2.0f};
    const bool is_in_view = viewport.contains(wanted.left, wanted.top) &&
                            viewport.contains(wanted.left + wanted.width, wanted.top + wanted.height);
    if (!is_in_view) continue;
    const Rectangle label = place(wanted, free, placed);
    placed.push_back(label);
    write_on_paper(label.left, label.top, arrow.color, arrow.name);
  }
}

std::vector<std::string> state_texts(const Simulation& simulation, std::size_t index) {
  const Sample& sample = simulation.shown(index).sample;
  std::vector<std::string> texts;
  const std::optional<double> error = energy_error(sample, simulation.run(index).start());
  if (error) texts.push_back("E/E0-1 " + short_number_text(*error, 3));
  if (sample.attitude_error_rad) {
    texts.push_back("attitude error " + short_number_text(*sample.attitude_error_rad, 3) + " rad");
  }
  const double det_R = sample.det_R();
  if (std::abs(det_R - 1.0) > 1e-6) texts.push_back("det R " + short_number_text(det_R, 4));
  return texts;
}

/// In one line if there is room for it, else in one line each, at the bottom of a view. Returns where it
/// begins.
float draw_state(const Rectangle& viewport, std::vector<std::string> texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : "  ") + text;
  if (ImGui::CalcTextSize(joined.c_str()).x < viewport.width - 2.0f * kMargin) texts = {joined};
  float top = viewport.top + viewport.height - kMargin + 2.0f;
  for (auto text = texts.rbegin(); text != texts.rend(); ++text) {
    top -= kLine;
    write_on_paper(viewport.left + kMargin, top, kFaintInk, *text);
  }
  return top;
}

/// Below the name, at the right.
void draw_legend(const Rectangle& viewport, float top) {
  const float right = viewport.left + viewport.width - kMargin;
  write_on_paper(right - ImGui::CalcTextSize("polhode").x, top + kLine, kPolhodeColor, "polhode");
  write_on_paper(right - ImGui::CalcTextSize("herpolhode").x, top + 2.0f * kLine, kHerpolhodeColor,
                 "herpolhode");
}

void draw_chip(float left, float top, std::size_t index) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({left - 2.0f, top - 2.0f}, {left + kChip + 2.0f, top + kChip + 2.0f}, im_color(kPaper));
  list.AddRectFilled({left, top}, {left + kChip, top + kChip}, im_color(contender_color(index)));
  if (!is_dashed(index)) return;
  list.AddRectFilled({left + 5.0f, top}, {left + 8.0f, top + kChip}, im_color(kPaper));
}

std::string status_text(const Session& session) {
  const Simulation& simulation = session.simulation();
  const Scenario& scenario = simulation.scenario();
  std::string text = scenario.name + "   t = " + short_number_text(simulation.shown_t_s(), 6) + " s   step " +
                     number_text(simulation.shown_step()) + "   dt = " + short_number_text(scenario.dt, 4) +
                     " s   speed x" + short_number_text(session.clock().speed(), 4) + "   " +
                     (session.is_running() ? "running" : "paused");
  if (session.is_late()) text += " (slower than asked: too much to compute)";
  return text;
}

}  // namespace

void draw_labels(const Session& session, const Scene& scene, const OrbitCamera& camera, bool is_teaching,
                 const Rectangle& viewport, std::size_t index) {
  const Simulation& simulation = session.simulation();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float left = viewport.left + kMargin;
  const float top = viewport.top + kMargin;
  list.PushClipRect({viewport.left, viewport.top},
                    {viewport.left + viewport.width, viewport.top + viewport.height});
  const float title_end = top + (simulation.has_diverged(index) ? 2.0f : 1.0f) * kLine;
  const float state_begin = draw_state(viewport, state_texts(simulation, index));
  const Rectangle free{viewport.left, title_end, viewport.width, state_begin - title_end};
  draw_arrow_names(simulation, scene, camera, is_teaching, viewport, free, index);
  if (is_teaching) draw_legend(viewport, top);
  draw_chip(left, top, index);
  write_on_paper(left + kChip + 6.0f, top, kInk, simulation.run(index).contender().name);
  if (simulation.has_diverged(index)) {
    const double t_s =
        static_cast<double>(simulation.run(index).diverged_at_step().value()) * simulation.scenario().dt;
    write_on_paper(left, top + kLine, kWarning, "diverged at t = " + short_number_text(t_s, 6) + " s");
  }
  list.AddRect({viewport.left, viewport.top},
               {viewport.left + viewport.width, viewport.top + viewport.height}, im_color(kRule));
  list.PopClipRect();
}

float status_height(const Session& session, float width) {
  const std::string text = status_text(session) + kHelpHint + session.notice();
  const bool fits = ImGui::CalcTextSize(text.c_str()).x + 8.0f * kMargin < width;
  return fits ? kStatusLine : kStatusLine + kLine;
}

void draw_status(const Session& session, const Rectangle& area) {
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      {area.left, area.top}, {area.left + area.width, area.top + area.height}, im_color(kPaper));
  const std::string text = status_text(session);
  const float top = area.top + 0.5f * (kStatusLine - ImGui::GetTextLineHeight());
  write(area.left + kMargin, top, kInk, text);
  const float hint_width = ImGui::CalcTextSize(kHelpHint).x;
  write(area.left + area.width - kMargin - hint_width, top, kFaintInk, kHelpHint);
  if (area.height > kStatusLine) {
    write(area.left + kMargin, top + kLine, kWarning, session.notice());
  } else {
    write(area.left + ImGui::CalcTextSize(text.c_str()).x + 4.0f * kMargin, top, kWarning, session.notice());
  }
}

}  // namespace polhode::demos
