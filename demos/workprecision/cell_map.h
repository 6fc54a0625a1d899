#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "record/contender.h"
#include "workprecision/axes.h"

namespace polhode::demos {

/// The result of one cell of a map.
struct CellResult {
  static constexpr std::size_t kMostFigures = 3;

  std::int64_t index;
  std::array<double, kMostFigures> figures;  ///< finite; the map defines their meaning, the others are 0
  std::int64_t diverged_step;                ///< 0 if none failed
};

inline bool diverged(const CellResult& result) {
  return result.diverged_step > 0;
}

/// A map that has the same cells for each contender, including one for each |omega| dt and inertia ratio. The
/// cells can be computed one by one, in any order, by any rank and thread.
class CellMap {
 public:
  std::vector<Contender> contenders;
  LogarithmicAxis omega_dt;
  LogarithmicAxis inertia_ratio;  ///< I_3/I_1

  CellMap(std::vector<Contender> compared, const LogarithmicAxis& omega_dt_axis,
          const LogarithmicAxis& ratio_axis)
      : contenders(std::move(compared)), omega_dt(omega_dt_axis), inertia_ratio(ratio_axis) {}
  CellMap(const CellMap&) = default;
  CellMap(CellMap&&) = default;
  CellMap& operator=(const CellMap&) = default;
  CellMap& operator=(CellMap&&) = default;
  virtual ~CellMap() = default;

  /// Cells are indexed contender by contender.
  std::int64_t cell_count() const { return static_cast<std::int64_t>(contenders.size()) * cells_of_each(); }
  /// Returns the number of cells of one contender.
  virtual std::int64_t cells_of_each() const = 0;
  /// Returns the number of figures of a cell.
  virtual std::size_t figure_count() const = 0;
  /// @throws Interrupted
  virtual CellResult computed(std::int64_t index) const = 0;

  /// Returns everything that the results depend on, including the program's version, in one line of JSON.
  virtual std::string description() const = 0;
  /// Returns the number of cells that keep a thread busy for some 0.1 s.
  virtual std::int64_t cells_in_round() const = 0;

  /// Return all cells as text, by their index; docs/work_precision.md documents columns and keys.
  virtual std::string csv(const std::vector<CellResult>& results) const = 0;
  virtual std::string json(const std::vector<CellResult>& results) const = 0;
  /// Returns a summary for the terminal.
  virtual std::string summary(const std::vector<CellResult>& results) const = 0;

 protected:
  /// Returns the keys that every description starts with; `journal` names the kind of map and its version.
  nlohmann::ordered_json description_start(const std::string& journal) const;

  /// Returns the description, the values of the axes, and for each contender the lists of its cells' figures.
  nlohmann::ordered_json cells_json(const std::vector<CellResult>& results) const;

 private:
  /// Returns the figures by their keys in the JSON file. A figure that the cell does not have is null.
  virtual nlohmann::ordered_json figures_json(const CellResult& result) const = 0;
};

}  // namespace polhode::demos
