#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace polhode::demos {

/// What one cell of a map came to.
struct CellResult {
  static constexpr std::size_t kMostFigures = 3;

  std::int64_t index;
  std::array<double, kMostFigures> figures;  ///< finite; the map says what they are, and 0 is in the others
  std::int64_t diverged_step;                ///< 0: none
};

/// What can be computed cell by cell, in any order and by anybody, and how it is written down.
class CellMap {
 public:
  CellMap() = default;
  CellMap(const CellMap&) = default;
  CellMap(CellMap&&) = default;
  CellMap& operator=(const CellMap&) = default;
  CellMap& operator=(CellMap&&) = default;
  virtual ~CellMap() = default;

  virtual std::int64_t cell_count() const = 0;
  /// How many figures a cell has.
  virtual std::size_t figure_count() const = 0;
  /// @throws Interrupted
  virtual CellResult computed(std::int64_t index) const = 0;

  /// All that the results depend on, this program's version included, in one line of JSON.
  virtual std::string description() const = 0;
  /// So many cells that a thread is busy with them for some 0.1 s.
  virtual std::int64_t cells_in_round() const = 0;

  /// All cells as text, by their index; demos/README.md documents columns and keys.
  virtual std::string csv(const std::vector<CellResult>& results) const = 0;
  virtual std::string json(const std::vector<CellResult>& results) const = 0;
  /// For the terminal.
  virtual std::string summary(const std::vector<CellResult>& results) const = 0;
};

}  // namespace polhode::demos
