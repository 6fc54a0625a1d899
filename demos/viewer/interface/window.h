#pragma once

struct GLFWwindow;

namespace polhode::demos {

/// A window with an OpenGL 3.3 context, which is current while it lives. One at a time.
class Window {
 public:
  /// @throws std::runtime_error that says why there is none to be had.
  Window(int width, int height, bool is_visible);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  /// Returns the pixels to a unit of the window's size.
  float pixels() const;
  /// Returns by how much the screen asks for larger texts than one of the usual density, in the window's units.
  float text_scale() const;

 private:
  GLFWwindow* window_;
};

}  // namespace polhode::demos
