#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/contender.h"
#include "workprecision/kernel.h"

namespace polhode::demos {

/// Values equally far apart in their logarithm, both ends included.
struct LogarithmicAxis {
  double from;
  double to;
  std::int64_t count;

  double at(std::int64_t i) const;
};

enum class SpinStart {
  middle_axis,  ///< 0.01 rad beside the middle axis, about which no spin is stable
  generic,      ///< along (3, 2, 4) in body axes
};

/// What is mapped: for each contender a cell for each pair of |omega| dt and inertia ratio I_3/I_1.
struct MapGrid {
  std::vector<Contender> contenders;
  LogarithmicAxis omega_dt{0.01, 3.0, 48};
  LogarithmicAxis inertia_ratio{1.1, 20.0, 24};
  std::int64_t steps = 1000;
  SpinStart start = SpinStart::middle_axis;

  /// Contender by contender, in each of them |omega| dt by |omega| dt.
  std::int64_t cell_count() const;
};

struct MapCell {
  std::size_t contender;  ///< its index in the grid
  double omega_dt;
  double inertia_ratio;
};

MapCell cell_at(const MapGrid& grid, std::int64_t index);

/// The step is 1/60 s in every cell, I_1 is 1 kg m^2: that matters to what is not free of scale, such as
/// Bullet's cap on the explicit torque.
inline constexpr double kMapTimeStep = 1.0 / 60.0;  // s

/// A body that can exist: I_2 is in the middle of what the triangle inequality leaves it between I_1 and I_3.
FreeBody body_of(const MapCell& cell, SpinStart start);

/// What a cell's run came to.
struct CellResult {
  std::int64_t index;
  double worst_energy_error;   ///< up to the divergence, if there was one
  std::int64_t diverged_step;  ///< 0: none
};

/// @throws Interrupted
CellResult computed(const MapGrid& grid, std::int64_t index);

/// All that the results depend on, this program's version included, in one line of JSON.
std::string description(const MapGrid& grid);

std::string to_string(SpinStart start);

}  // namespace polhode::demos
