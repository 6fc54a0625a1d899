#include "viewer/interface/plots.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scenario/number_text.h"
#include "viewer/interface/theme.h"
#include "viewer/model/plot_data.h"

namespace polhode::demos {

namespace {

constexpr std::size_t kMostPoints = 400;
/// The least width of a plot. A narrower panel scrolls.
constexpr float kLeastWidth = 250.0f;
constexpr float kLeastHeight = 150.0f;
constexpr float kLeftMargin = 72.0f;
constexpr float kRightMargin = 14.0f;
constexpr float kTopMargin = 26.0f;
constexpr float kBottomMargin = 24.0f;

/// Maps times and values to pixels.
struct Axes {
  Rectangle frame;
  Range t_s;
  Range value;

  ImVec2 at(double t, double v) const {
    // Limited, so that pixels far outside stay numbers that can be drawn.
    const double height = std::clamp((v - value.lowest) / (value.highest - value.lowest), -2.0, 3.0);
    const double across = (t - t_s.lowest) / (t_s.highest - t_s.lowest);
    return {frame.left + frame.width * static_cast<float>(across),
            frame.top + frame.height * static_cast<float>(1.0 - height)};
  }
};

void draw_ticks(ImDrawList& list, const Axes& axes, bool is_logarithmic) {
  const Rectangle& frame = axes.frame;
  const float half_line = 0.5f * ImGui::GetTextLineHeight();
  std::string previous;
  for (const double value : ticks(axes.value)) {
    if (is_logarithmic && value != std::round(value)) continue;
    const float y = axes.at(axes.t_s.lowest, value).y;
    const std::string text =
        is_logarithmic ? "1e" + short_number_text(value, 3) : short_number_text(value, 7);
    if (text == previous) continue;  // repeats for a line bent by rounding only
    previous = text;
    list.AddLine({frame.left, y}, {frame.left + frame.width, y}, im_color(kRule, 0.6f));
    list.AddText({frame.left - scaled(5.0f) - ImGui::CalcTextSize(text.c_str()).x, y - half_line},
                 im_color(kFaintInk), text.c_str());
  }
  float free_from = 0.0f;
  for (const double t : ticks(axes.t_s)) {
    const float x = axes.at(t, axes.value.lowest).x;
    const std::string text = short_number_text(t, 6);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float bottom = frame.top + frame.height;
    list.AddLine({x, bottom}, {x, bottom + 3.0f}, im_color(kFaintInk));
    const bool meets_unit = x + 0.5f * width > frame.left + frame.width - scaled(36.0f);
    if (meets_unit || x - 0.5f * width < free_from) continue;
    free_from = x + 0.5f * width + scaled(6.0f);
    list.AddText({x - 0.5f * width, bottom + scaled(4.0f)}, im_color(kFaintInk), text.c_str());
  }
  list.AddText({frame.left + frame.width - scaled(26.0f), frame.top + frame.height + scaled(4.0f)},
               im_color(kFaintInk), "t, s");
}

void draw_curve(ImDrawList& list, const Axes& axes, const Curve& curve, std::size_t index) {
  const bool dashed = is_dashed(index);
  for (std::size_t point = 1; point < curve.size(); ++point) {
    if (dashed && (point / 4) % 2 == 1) continue;
    list.AddLine(axes.at(curve[point - 1].t_s, curve[point - 1].value),
                 axes.at(curve[point].t_s, curve[point].value), im_color(contender_color(index)), 1.8f);
  }
}

void draw_plot(const Simulation& simulation, const PlotSubject& subject, const Rectangle& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<Curve> curves = curves_of(simulation, subject, kMostPoints);
  const double first_s = static_cast<double>(simulation.first_kept_step()) * simulation.scenario().dt;
  const Range t_s{first_s, std::max(simulation.shown_t_s(), first_s + simulation.scenario().dt)};
  const Axes axes{{area.left + scaled(kLeftMargin), area.top + scaled(kTopMargin),
                   area.width - scaled(kLeftMargin) - scaled(kRightMargin),
                   area.height - scaled(kTopMargin) - scaled(kBottomMargin)},
                  t_s,
                  value_range(curves)};
  const auto leaving = std::count_if(curves.begin(), curves.end(),
                                     [&](const Curve& curve) { return leaves(curve, axes.value); });
  const bool is_known = std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return !c.empty(); });
  std::string remark;
  if (!is_known) remark = "unknown here";
  if (leaving > 0) remark = number_text(static_cast<std::int64_t>(leaving)) + " off the scale";
  list.AddText({area.left + scaled(kLeftMargin), area.top + scaled(5.0f)}, im_color(kInk),
               subject.title().c_str());
  if (is_known) draw_ticks(list, axes, subject.quantity->is_error());
  const ImVec2 corner{axes.frame.left, axes.frame.top};
  const ImVec2 far_corner{axes.frame.left + axes.frame.width, axes.frame.top + axes.frame.height};
  list.PushClipRect(corner, far_corner, true);
  // Draws the first contender, by default the exact one, last and thus on top.
  for (std::size_t index = curves.size(); index-- > 0;) draw_curve(list, axes, curves[index], index);
  list.PopClipRect();
  list.AddRect(corner, far_corner, im_color(kFaintInk));
  const float remark_width = ImGui::CalcTextSize(remark.c_str()).x;
  list.AddText({far_corner.x - remark_width - 4.0f, corner.y + 2.0f}, im_color(kFaintInk), remark.c_str());
}

}  // namespace

void draw_plots(const Session& session, const Rectangle& area) {
  ImGui::SetNextWindowPos({area.left, area.top});
  ImGui::SetNextWindowSize({area.width, area.height});
  ImGui::Begin("plots", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  const auto columns = static_cast<std::size_t>(std::clamp(area.width / scaled(kLeastWidth), 1.0f, 5.0f));
  const std::vector<PlotSubject> subjects = plot_subjects();
  const std::size_t rows = (subjects.size() + columns - 1) / columns;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rectangle all{
      corner.x, corner.y, ImGui::GetContentRegionAvail().x,
      std::max(ImGui::GetContentRegionAvail().y, scaled(kLeastHeight) * static_cast<float>(rows))};
  for (std::size_t index = 0; index < subjects.size(); ++index) {
    draw_plot(session.simulation(), subjects[index], grid_cell_of_columns(all, index, columns, rows));
  }
  ImGui::Dummy({1.0f, all.height - 1.0f});
  ImGui::End();
}

}  // namespace polhode::demos
