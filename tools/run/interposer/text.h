#pragma once

#include <cstdarg>
#include <cstddef>
#include <cstdio>

#include "run/interposer/report.h"

namespace polhode::run {

/// A text of limited length, without the C++ library. Truncates text that does not fit.
class Text {
 public:
  __attribute__((format(printf, 2, 3))) void add(const char* format, ...) {
    va_list values;
    va_start(values, format);
    const int length = std::vsnprintf(text_ + length_, kLongest - length_, format, values);
    va_end(values);
    if (length > 0) length_ = length_ + length < kLongest ? length_ + length : kLongest - 1;
  }
  void make_printable() { replace_control_characters(text_); }
  const char* c_str() const { return text_; }

 private:
  static constexpr std::size_t kLongest = 4096;

  char text_[kLongest] = "";
  std::size_t length_ = 0;
};

}  // namespace polhode::run
