#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace polhode::demos {

/// Three bytes per pixel, row by row from the top.
struct Image {
  int width;
  int height;
  std::vector<std::uint8_t> rgb;
};

/// @throws std::runtime_error if the file cannot be written
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace polhode::demos
