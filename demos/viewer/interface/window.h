#pragma once

struct GLFWwindow;

namespace polhode::demos {

/// A window with an OpenGL 3.3 context, which is current during its lifetime. Only one can exist at a time.
class Window {
 public:
  /// @throws std::runtime_error that says why no window can be opened
  Window(int width, int height, bool is_visible);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  /// Returns the pixels per unit of the window's size.
  float pixels() const;
  /// Returns the factor by which texts must grow on this screen, in the window's units.
  float text_scale() const;

 private:
  GLFWwindow* window_;
};

}  // namespace polhode::demos
