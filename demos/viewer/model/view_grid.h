#pragma once

#include <cstddef>

namespace polhode::demos {

/// A rectangle in pixels from the top left corner of the picture.
struct Rectangle {
  float left = 0.0f;
  float top = 0.0f;
  float width = 0.0f;
  float height = 0.0f;

  bool contains(float x, float y) const {
    return x >= left && x < left + width && y >= top && y < top + height;
  }
};

/// Returns cell `index` of `count` equal cells of an area, shaped to leave the most room for a body.
Rectangle grid_cell(const Rectangle& area, std::size_t index, std::size_t count);

/// Does the same for a given number of columns and rows.
Rectangle grid_cell_of_columns(const Rectangle& area, std::size_t index, std::size_t columns,
                               std::size_t rows);

}  // namespace polhode::demos
