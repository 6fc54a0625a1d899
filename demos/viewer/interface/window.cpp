#include "viewer/interface/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <stdexcept>
#include <string>

namespace polhode::demos {

namespace {

[[noreturn]] void refuse() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  const std::string text = reason != nullptr ? reason : "unknown reason";
  glfwTerminate();
  throw std::runtime_error("no window can be opened (" + text +
                           "); without a display valid is --screenshot FILE.png");
}

}  // namespace

Window::Window(int width, int height, bool is_visible) {
  if (glfwInit() != GLFW_TRUE) refuse();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SAMPLES, 4);
  glfwWindowHint(GLFW_VISIBLE, is_visible ? GLFW_TRUE : GLFW_FALSE);
  window_ = glfwCreateWindow(width, height, "polhode_viewer", nullptr, nullptr);
  if (window_ == nullptr) refuse();
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

float Window::pixels() const {
  int width = 0;
  int width_pixels = 0;
  glfwGetWindowSize(window_, &width, nullptr);
  glfwGetFramebufferSize(window_, &width_pixels, nullptr);
  return static_cast<float>(width_pixels) / static_cast<float>(width);
}

float Window::text_scale() const {
  float scale = 1.0f;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  return scale / pixels();
}

}  // namespace polhode::demos
