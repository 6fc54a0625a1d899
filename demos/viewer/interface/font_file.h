#pragma once

#include <string_view>

namespace polhode::demos {

/// Returns the bytes of font/DejaVuSans.ttf.
std::string_view font_file();

}  // namespace polhode::demos
