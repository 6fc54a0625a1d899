#include "viewer/graphics/framebuffer.h"

#include <algorithm>
#include <stdexcept>

#include "viewer/graphics/opengl.h"

namespace polhode::demos {

namespace {

constexpr int kSamples = 4;
constexpr std::size_t kBytesPerPixel = 3;

unsigned int make_storage(GLenum format, int samples, GLenum attachment, int width, int height) {
  unsigned int storage = 0;
  glGenRenderbuffers(1, &storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, storage);
  return storage;
}

void check_complete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL cannot make a picture of that size");
  }
}

Image read_bound(int width, int height) {
  Image image{width, height, {}};
  image.rgb.resize(kBytesPerPixel * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // OpenGL's first row is the lowest.
  const std::size_t row = kBytesPerPixel * static_cast<std::size_t>(width);
  for (std::size_t upper = 0, lower = static_cast<std::size_t>(height) - 1; upper < lower; ++upper, --lower) {
    std::swap_ranges(image.rgb.begin() + static_cast<std::ptrdiff_t>(upper * row),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>((upper + 1) * row),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>(lower * row));
  }
  return image;
}

}  // namespace

Framebuffer::Framebuffer(int width, int height) : width_(width), height_(height) {
  glGenFramebuffers(1, &plain_framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, plain_framebuffer_);
  plain_color_ = make_storage(GL_RGBA8, 0, GL_COLOR_ATTACHMENT0, width, height);
  check_complete();
  glGenFramebuffers(1, &smoothed_framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, smoothed_framebuffer_);
  smoothed_color_ = make_storage(GL_RGBA8, kSamples, GL_COLOR_ATTACHMENT0, width, height);
  smoothed_depth_ = make_storage(GL_DEPTH_COMPONENT24, kSamples, GL_DEPTH_ATTACHMENT, width, height);
  check_complete();
}

Framebuffer::~Framebuffer() {
  const unsigned int storages[] = {smoothed_color_, smoothed_depth_, plain_color_};
  glDeleteRenderbuffers(3, storages);
  const unsigned int framebuffers[] = {smoothed_framebuffer_, plain_framebuffer_};
  glDeleteFramebuffers(2, framebuffers);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, smoothed_framebuffer_);
}

Image Framebuffer::read() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, smoothed_framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_framebuffer_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, plain_framebuffer_);
  Image image = read_bound(width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return image;
}

Image read_window(int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return read_bound(width, height);
}

}  // namespace polhode::demos
