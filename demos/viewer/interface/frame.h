#pragma once

#include <optional>

#include "viewer/graphics/renderer.h"
#include "viewer/graphics/scene.h"
#include "viewer/interface/view_state.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Draws a session: the views side by side, with the panels around them. Needs a current OpenGL context and a
/// Gui.
class Frame {
 public:
  Frame(Session& session, ViewState& view);

  /// Draws into the bound framebuffer, which has `scale` pixels per unit of width and height. Call this after
  /// the platform's part of Dear ImGui's frame has begun.
  void draw(int width, int height, float scale = 1.0f);
  /// Resets the camera.
  void reset_camera();
  /// Returns the area of the contenders' views.
  const Rectangle& views() const { return views_; }

 private:
  void follow_session();
  void lay_out(float width, float height);
  void draw_panels(float width, float height);
  void draw_views();
  OrbitCamera camera_of(std::size_t index) const;

  Session& session_;
  ViewState& view_;
  Renderer renderer_;
  std::optional<Scene> scene_;
  int generation_ = -1;
  std::string scenario_name_;
  Rectangle views_;
  Rectangle status_;
};

}  // namespace polhode::demos
