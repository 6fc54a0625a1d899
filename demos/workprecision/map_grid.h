#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workprecision/cell_map.h"
#include "workprecision/kernel.h"

namespace polhode::demos {

enum class SpinStart {
  middle_axis,  ///< 0.01 rad from the middle axis, about which no spin is stable
  generic,      ///< along (3, 2, 4) in body axes
};

/// A map with a cell for each contender and each pair of |omega| dt and inertia ratio, ordered by |omega| dt
/// first.
struct MapGrid : CellMap {
  MapGrid() : CellMap({}, {0.01, 3.0, 48}, {1.1, 20.0, 24}) {}

  std::int64_t steps = 1000;
  SpinStart start = SpinStart::middle_axis;

  std::int64_t cells_of_each() const override { return omega_dt.count * inertia_ratio.count; }
  /// Largest |E/E0 - 1|, up to the divergence if there is one.
  std::size_t figure_count() const override { return 1; }
  CellResult computed(std::int64_t index) const override;
  std::string description() const override;
  std::int64_t cells_in_round() const override;
  std::string csv(const std::vector<CellResult>& results) const override;
  std::string json(const std::vector<CellResult>& results) const override;
  /// Returns a line for each contender: how many cells diverged, and its energy errors.
  std::string summary(const std::vector<CellResult>& results) const override;

 private:
  nlohmann::ordered_json figures_json(const CellResult& result) const override;
};

struct MapCell {
  std::size_t contender;  ///< its index in the grid
  double omega_dt;
  double inertia_ratio;
};

MapCell cell_at(const MapGrid& grid, std::int64_t index);

/// The step is 1/60 s in every cell, and I_1 is 1 kg m^2. This matters to contenders that depend on the
/// scale, such as Bullet's limited explicit torque.
inline constexpr double kMapTimeStep = 1.0 / 60.0;  // s

/// Returns physically possible moments with I_1 = 1 kg m^2: I_2 is the middle of the range that the triangle
/// inequality allows between I_1 and I_3.
Vector3 moments_of(double inertia_ratio);

FreeBody body_of(const MapCell& cell, SpinStart start);

std::string to_string(SpinStart start);

}  // namespace polhode::demos
