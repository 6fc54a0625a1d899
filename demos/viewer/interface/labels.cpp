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

float margin() {
  return scaled(8.0f);
}

float chip_size() {
  return scaled(14.0f);
}

float line_height() {
  return scaled(19.0f);
}

float status_line() {
  return scaled(28.0f);
}

constexpr char kHelpHint[] = "H: keys";
/// A shorter arrow would be hidden by its name.
constexpr double kShortestNamed = 0.08;

void write(float left, float top, Color color, const std::string& text) {
  ImGui::GetBackgroundDrawList()->AddText({left, top}, im_color(color), text.c_str());
}

float text_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

/// Returns the text, shortened at the end if it is too wide.
std::string shortened_to(float width, std::string text) {
  if (text_width(text) <= width) return text;
  const auto is_inside_a_letter = [](char byte) { return (byte & 0xC0) == 0x80; };  // of UTF-8
  while (!text.empty() && text_width(text + "...") > width) {
    while (text.size() > 1 && is_inside_a_letter(text.back())) text.pop_back();
    text.pop_back();
  }
  return text + "...";
}

/// Draws a light ground behind the text, which may lie over a body.
void write_on_paper(float left, float top, Color color, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      {left - 2.0f, top - 1.0f}, {left + size.x + 2.0f, top + size.y + 1.0f}, im_color(kPaper, 0.75f));
  write(left, top, color, text);
}

/// Moves a label between the texts at the top and at the bottom of a view: below the labels that it would
/// cover, or to the right of them if there is no room below.
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

/// Writes the texts in one line or, if there is no room, one below the other, at the bottom of a view. Leaves
/// out those that are too long for the view or would hide the body. Returns the top of the texts.
float draw_state(const Rectangle& viewport, std::vector<std::string> texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : "  ") + text;
  const float room = viewport.width - 2.0f * margin();
  if (text_width(joined) < room) texts = {joined};
  float top = viewport.top + viewport.height - margin() + 2.0f;
  for (auto text = texts.rbegin(); text != texts.rend(); ++text) {
    const bool hides_body = top - line_height() < viewport.top + 0.5f * viewport.height;
    if (hides_body || text_width(*text) >= room) continue;
    top -= line_height();
    write_on_paper(viewport.left + margin(), top, kFaintInk, *text);
  }
  return top;
}

/// Draws the legend below the name, on the right.
void draw_legend(const Rectangle& viewport, float top) {
  const float right = viewport.left + viewport.width - margin();
  write_on_paper(right - text_width("polhode"), top + line_height(), kPolhodeColor, "polhode");
  write_on_paper(right - text_width("herpolhode"), top + 2.0f * line_height(), kHerpolhodeColor,
                 "herpolhode");
}

void draw_chip(float left, float top, std::size_t index) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({left - 2.0f, top - 2.0f}, {left + chip_size() + 2.0f, top + chip_size() + 2.0f},
                     im_color(kPaper));
  list.AddRectFilled({left, top}, {left + chip_size(), top + chip_size()}, im_color(contender_color(index)));
  if (!is_dashed(index)) return;
  list.AddRectFilled({left + 5.0f, top}, {left + 8.0f, top + chip_size()}, im_color(kPaper));
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
  const float left = viewport.left + margin();
  const float top = viewport.top + margin();
  list.PushClipRect({viewport.left, viewport.top},
                    {viewport.left + viewport.width, viewport.top + viewport.height});
  const float title_end = top + (simulation.has_diverged(index) ? 2.0f : 1.0f) * line_height();
  const float state_begin = draw_state(viewport, state_texts(simulation, index));
  const Rectangle free{viewport.left, title_end, viewport.width, state_begin - title_end};
  draw_arrow_names(simulation, scene, camera, is_teaching, viewport, free, index);
  if (is_teaching) draw_legend(viewport, top);
  draw_chip(left, top, index);
  const float name_left = left + chip_size() + scaled(6.0f);
  const float right = viewport.left + viewport.width - margin();
  write_on_paper(name_left, top, kInk,
                 shortened_to(right - name_left, simulation.run(index).contender().name));
  if (simulation.has_diverged(index)) {
    const double t_s =
        static_cast<double>(simulation.run(index).diverged_at_step().value()) * simulation.scenario().dt;
    write_on_paper(left, top + line_height(), kWarning,
                   shortened_to(right - left, "diverged at t = " + short_number_text(t_s, 6) + " s"));
  }
  list.AddRect({viewport.left, viewport.top},
               {viewport.left + viewport.width, viewport.top + viewport.height}, im_color(kRule));
  list.PopClipRect();
}

float status_height(const Session& session, float width) {
  const std::string text = status_text(session) + kHelpHint + session.notice();
  const bool fits = text_width(text) + 8.0f * margin() < width;
  return fits ? status_line() : status_line() + line_height();
}

void draw_status(const Session& session, const Rectangle& area) {
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      {area.left, area.top}, {area.left + area.width, area.top + area.height}, im_color(kPaper));
  const std::string text = shortened_to(area.width - 2.0f * margin(), status_text(session));
  const float top = area.top + 0.5f * (status_line() - ImGui::GetTextLineHeight());
  write(area.left + margin(), top, kInk, text);
  const float hint_left = area.left + area.width - margin() - text_width(kHelpHint);
  if (area.left + text_width(text) + 4.0f * margin() < hint_left) write(hint_left, top, kFaintInk, kHelpHint);
  if (area.height > status_line()) {
    write(area.left + margin(), top + line_height(), kWarning,
          shortened_to(area.width - 2.0f * margin(), session.notice()));
  } else {
    write(area.left + text_width(text) + 4.0f * margin(), top, kWarning, session.notice());
  }
}

}  // namespace polhode::demos
