#pragma once

#include <array>
#include <optional>

#include "record/sample.h"

namespace polhode::demos {

/// The quantities that are plotted over time.
enum class Quantity {
  energy,
  energy_x,
  energy_y,
  energy_z,
  momentum,
  momentum_angle,
  determinant,
  attitude_error
};

struct QuantityDescription {
  Quantity quantity;
  const char* name;
  const char* unit;
  bool is_logarithmic;  ///< errors span many powers of ten
};

inline constexpr std::array<QuantityDescription, 8> kQuantities = {
    {{Quantity::energy, "energy", "J", false},
     {Quantity::momentum, "|L|", "kg m^2/s", false},
     {Quantity::momentum_angle, "turn of L", "rad", false},
     {Quantity::attitude_error, "attitude error", "rad", true},
     {Quantity::determinant, "det R", "no unit", false},
     {Quantity::energy_x, "energy about body x", "J", false},
     {Quantity::energy_y, "energy about body y", "J", false},
     {Quantity::energy_z, "energy about body z", "J", false}}};

/// Returns the value, or nothing if the sample has no such value.
std::optional<double> value_of(Quantity quantity, const Sample& sample, const Sample& start);

}  // namespace polhode::demos
