#include "viewer/interface/screenshot.h"

#include "viewer/graphics/framebuffer.h"
#include "viewer/graphics/headless_context.h"
#include "viewer/interface/frame.h"
#include "viewer/interface/theme.h"
#include "viewer/interface/window.h"

namespace polhode::demos {

namespace {

Image draw_image(Session& session, const ViewerOptions& options) {
  const Gui gui;
  ViewState view;
  view.is_teaching = options.is_teaching;
  view.has_panels = !options.has_no_panels;
  Frame frame(session, view);
  const Framebuffer framebuffer(options.width, options.height);
  // Dear ImGui fits windows to their content in their second frame.
  for (int repetition = 0; repetition < 2; ++repetition) {
    ImGui::GetIO().DisplaySize = {static_cast<float>(options.width), static_cast<float>(options.height)};
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    framebuffer.bind();
    frame.draw(options.width, options.height);
  }
  return framebuffer.read();
}

}  // namespace

Image take_screenshot(Session& session, const ViewerOptions& options) {
  if (options.through_window) {
    const Window window(options.width, options.height, false);
    return draw_image(session, options);
  }
  const HeadlessContext context;
  return draw_image(session, options);
}

}  // namespace polhode::demos
