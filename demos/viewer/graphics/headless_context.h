#pragma once

namespace polhode::demos {

/// An OpenGL 3.3 context without display or window, current during its lifetime.
class HeadlessContext {
 public:
  /// @throws std::runtime_error if no such context is available
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace polhode::demos
