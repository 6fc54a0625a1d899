#pragma once

#include <string_view>

namespace polhode::demos {

/// The bytes of font/DejaVuSans.ttf.
std::string_view font_file();

}  // namespace polhode::demos
