#include "viewer/interface/frame.h"

#include <imgui/backends/imgui_impl_opengl3.h>

#include "viewer/interface/control_panel.h"
#include "viewer/interface/help.h"
#include "viewer/interface/labels.h"
#include "viewer/interface/plots.h"
#include "viewer/interface/theme.h"

namespace polhode::demos {

namespace {

constexpr float kPanelWidth = 330.0f;
constexpr float kPlotsPart = 0.34f;

}  // namespace

Frame::Frame(Session& session, ViewState& view) : session_(session), view_(view) {
  follow_session();
}

void Frame::draw(int width, int height, float scale) {
  follow_session();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  lay_out(static_cast<float>(width), static_cast<float>(height));
  draw_panels(static_cast<float>(width), static_cast<float>(height));
  follow_session();  // a panel may have started the session over
  renderer_.clear(width, height, scale);
  draw_views();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Frame::reset_camera() {
  view_.camera = OrbitCamera();
  view_.camera.look_at(scene_->centre_W(), scene_->radius());
}

void Frame::follow_session() {
  if (generation_ == session_.generation()) return;
  generation_ = session_.generation();
  scene_.emplace(session_.simulation());
  view_.edited = changes_of(session_.simulation().scenario());
  const std::string& name = session_.simulation().scenario().name;
  if (name != scenario_name_) reset_camera();
  scenario_name_ = name;
}

void Frame::lay_out(float width, float height) {
  const float left = view_.has_panels ? scaled(kPanelWidth) : 0.0f;
  const float plots = view_.has_panels ? kPlotsPart * height : 0.0f;
  status_ = {left, 0.0f, width - left, status_height(session_, width - left)};
  views_ = {left, status_.height, width - left, height - status_.height - plots};
}

void Frame::draw_panels(float width, float height) {
  if (view_.has_panels) {
    draw_control_panel(session_, view_, {0.0f, 0.0f, scaled(kPanelWidth), height});
    const float bottom = views_.top + views_.height;
    draw_plots(session_, {views_.left, bottom, views_.width, height - bottom});
  }
  if (view_.has_help) draw_help(width, height);
}

void Frame::draw_views() {
  const std::size_t count = session_.simulation().size();
  for (std::size_t index = 0; index < count; ++index) {
    const Rectangle viewport = grid_cell(views_, index, count);
    const OrbitCamera camera = camera_of(index);
    renderer_.begin(viewport, camera);
    scene_->draw(renderer_, session_.simulation(), index, view_.is_teaching);
    draw_labels(session_, *scene_, camera, view_.is_teaching, viewport, index);
  }
  renderer_.end();
  draw_status(session_, status_);
}

OrbitCamera Frame::camera_of(std::size_t index) const {
  OrbitCamera camera = view_.camera;
  if (view_.follows_bodies) camera.move_to(session_.simulation().shown(index).sample.position_W);
  return camera;
}

}  // namespace polhode::demos
