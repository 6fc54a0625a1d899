#include "viewer/model/view_grid.h"

#include <algorithm>

namespace polhode::demos {

namespace {

/// The best view is slightly wider than high: a body needs both equally, its labels more width.
constexpr float kGoodAspect = 1.25f;

/// Returns the size of the largest well-shaped view that fits into a cell, for this number of columns.
float room_in_cell(const Rectangle& area, std::size_t columns, std::size_t count) {
  const std::size_t rows = (count + columns - 1) / columns;
  return std::min(area.width / static_cast<float>(columns),
                  kGoodAspect * area.height / static_cast<float>(rows));
}

}  // namespace

Rectangle grid_cell(const Rectangle& area, std::size_t index, std::size_t count) {
  std::size_t columns = 1;
  for (std::size_t candidate = 2; candidate <= count; ++candidate) {
    if (room_in_cell(area, candidate, count) > room_in_cell(area, columns, count)) columns = candidate;
  }
  return grid_cell_of_columns(area, index, columns, (count + columns - 1) / columns);
}

Rectangle grid_cell_of_columns(const Rectangle& area, std::size_t index, std::size_t columns,
                               std::size_t rows) {
  const float width = area.width / static_cast<float>(columns);
  const float height = area.height / static_cast<float>(rows);
  const std::size_t row = index / columns;
  return {area.left + width * static_cast<float>(index % columns),
          area.top + height * static_cast<float>(row), width, height};
}

}  // namespace polhode::demos
