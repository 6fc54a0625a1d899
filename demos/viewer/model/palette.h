#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace polhode::demos {

struct Color {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

/// Okabe and Ito's colours, which colour-blind people can tell apart, darkened where a light ground needs it,
/// and two more. palette.js of the report has the same.
inline constexpr std::array<Color, 9> kContenderColors = {{{0x00, 0x72, 0xB2},
                                                           {0xD5, 0x5E, 0x00},
                                                           {0x00, 0x9E, 0x73},
                                                           {0xCC, 0x5F, 0xA0},
                                                           {0x3B, 0xA3, 0xE0},
                                                           {0xD9, 0x8E, 0x00},
                                                           {0x3C, 0x41, 0x47},
                                                           {0x99, 0x8A, 0x00},
                                                           {0x88, 0x22, 0x55}}};

/// The colours of omega's paths in the teaching view.
inline constexpr Color kPolhodeColor{0xC0, 0x00, 0x40};
inline constexpr Color kHerpolhodeColor{0x20, 0x20, 0x80};

inline Color contender_color(std::size_t index) {
  return kContenderColors[index % kContenderColors.size()];
}

/// Returns true for contenders after the last colour, which are drawn dashed.
inline bool is_dashed(std::size_t index) {
  return index >= kContenderColors.size();
}

}  // namespace polhode::demos
