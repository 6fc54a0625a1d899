#pragma once

#include "viewer/graphics/image.h"

namespace polhode::demos {

/// A picture to draw into instead of a window, with antialiasing.
class Framebuffer {
 public:
  /// @throws std::runtime_error if the driver cannot create it
  Framebuffer(int width, int height);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Directs drawing to this framebuffer.
  void bind() const;
  /// Reads the finished picture.
  Image read() const;

 private:
  int width_;
  int height_;
  unsigned int smoothed_framebuffer_ = 0;
  unsigned int smoothed_color_ = 0;
  unsigned int smoothed_depth_ = 0;
  unsigned int plain_framebuffer_ = 0;
  unsigned int plain_color_ = 0;
};

/// Reads the picture in a window's back buffer.
Image read_window(int width, int height);

}  // namespace polhode::demos
