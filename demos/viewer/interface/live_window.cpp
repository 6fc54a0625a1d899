#include "viewer/interface/live_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>

#include <cmath>

#include "command_line/interruption.h"
#include "viewer/graphics/framebuffer.h"
#include "viewer/interface/frame.h"
#include "viewer/interface/theme.h"
#include "viewer/interface/window.h"

namespace polhode::demos {

namespace {

/// Limits the time for steps in a frame; the rest of a sixtieth of a second is for drawing.
constexpr std::chrono::milliseconds kStepBudget{10};
constexpr double kRadiansPerPixel = 0.008;
constexpr double kZoomPerNotch = 0.9;

/// A session in a window. The user's actions arrive through GLFW's callbacks.
class LiveWindow {
 public:
  LiveWindow(Session& session, const ViewerOptions& options)
      : session_(session), window_(options.width, options.height, true) {
    view_.is_teaching = options.is_teaching;
    view_.has_panels = !options.has_no_panels;
    frame_.emplace(session_, view_);
    glfwSetWindowUserPointer(window_.handle(), this);
    glfwSetKeyCallback(window_.handle(), [](GLFWwindow* window, int key, int, int action, int) {
      if (action != GLFW_RELEASE) of(window).press(key);
    });
    glfwSetCharCallback(window_.handle(),
                        [](GLFWwindow* window, unsigned int character) { of(window).type(character); });
    glfwSetScrollCallback(window_.handle(),
                          [](GLFWwindow* window, double, double notches) { of(window).scroll(notches); });
    ImGui_ImplGlfw_InitForOpenGL(window_.handle(), true);  // also calls these callbacks
  }
  ~LiveWindow() { ImGui_ImplGlfw_Shutdown(); }
  LiveWindow(const LiveWindow&) = delete;
  LiveWindow& operator=(const LiveWindow&) = delete;

  void run() {
    double before_s = glfwGetTime();
    while (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE) {
      throw_if_interrupted();
      glfwPollEvents();
      const double now_s = glfwGetTime();
      session_.advance(now_s - before_s, kStepBudget);
      before_s = now_s;
      turn_camera();
      draw();
    }
  }

 private:
  static LiveWindow& of(GLFWwindow* window) {
    return *static_cast<LiveWindow*>(glfwGetWindowUserPointer(window));
  }

  void press(int key) {
    if (ImGui::GetIO().WantTextInput) return;
    switch (key) {
      case GLFW_KEY_SPACE:
        return session_.apply(Action::run_or_pause);
      case GLFW_KEY_RIGHT:
        return session_.apply(Action::step);
      case GLFW_KEY_LEFT:
        return session_.apply(Action::step_back);
      case GLFW_KEY_HOME:
        return frame_->reset_camera();
      case GLFW_KEY_F1:
        view_.has_help = !view_.has_help;
        return;
      case GLFW_KEY_ESCAPE:
        return glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
      default:
        return;
    }
  }

  /// Handles letters and signs of the keyboard's layout.
  void type(unsigned int character) {
    if (ImGui::GetIO().WantTextInput) return;
    switch (character) {
      case 'r':
      case 'R':
        return session_.apply(Action::reset);
      case '+':
      case '=':
        return session_.apply(Action::faster);
      case '-':
        return session_.apply(Action::slower);
      case 't':
      case 'T':
        view_.is_teaching = !view_.is_teaching;
        return;
      case 'p':
      case 'P':
        view_.has_panels = !view_.has_panels;
        return;
      case 'f':
      case 'F':
        view_.follows_bodies = !view_.follows_bodies;
        return;
      case 'h':
      case 'H':
        view_.has_help = !view_.has_help;
        return;
      default:
        return;
    }
  }

  void scroll(double notches) {
    if (!ImGui::GetIO().WantCaptureMouse) view_.camera.zoom(std::pow(kZoomPerNotch, notches));
  }

  void turn_camera() {
    double x = 0.0;
    double y = 0.0;
    glfwGetCursorPos(window_.handle(), &x, &y);
    const bool is_down = glfwGetMouseButton(window_.handle(), GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    if (is_down && was_down_ && !ImGui::GetIO().WantCaptureMouse) {
      view_.camera.orbit(-kRadiansPerPixel * (x - cursor_x_), kRadiansPerPixel * (y - cursor_y_));
    }
    was_down_ = is_down;
    cursor_x_ = x;
    cursor_y_ = y;
  }

  void draw() {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_.handle(), &width, &height);
    int width_pixels = 0;
    int height_pixels = 0;
    glfwGetFramebufferSize(window_.handle(), &width_pixels, &height_pixels);
    if (width == 0 || height == 0) return glfwWaitEventsTimeout(0.1);  // minimized
    ImGui_ImplGlfw_NewFrame();
    frame_->draw(width, height, static_cast<float>(width_pixels) / static_cast<float>(width));
    if (view_.wanted_png) write_picture(width_pixels, height_pixels);
    glfwSwapBuffers(window_.handle());
  }

  void write_picture(int width, int height) {
    try {
      write_png(read_window(width, height), *view_.wanted_png);
      session_.set_notice("written: " + view_.wanted_png->string());
    } catch (const std::exception& error) {
      session_.set_notice(error.what());
    }
    view_.wanted_png.reset();
  }

  Session& session_;
  ViewState view_;
  // Members that need the context are declared after it, so that they are destroyed first.
  Window window_;
  Gui gui_{window_.text_scale(), window_.pixels()};
  std::optional<Frame> frame_;
  bool was_down_ = false;
  double cursor_x_ = 0.0;
  double cursor_y_ = 0.0;
};

}  // namespace

void show_window(Session& session, const ViewerOptions& options) {
  LiveWindow(session, options).run();
}

}  // namespace polhode::demos
