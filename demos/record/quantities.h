#pragma once

#include <optional>
#include <vector>

#include "record/sample.h"

/// The quantities of a body over time. The CSV's columns and the plots of report and viewer are made from
/// this table.
namespace polhode::demos {

/// A sample with the values that some quantities are relative to.
struct Instant {
  const Sample& sample;
  const Sample& start;
  Vector3 inertia_B;
};

/// How report and viewer draw a quantity: not at all, as part of the 3D views, or as a plot. The axis of
/// errors is logarithmic and shows magnitudes; an adaptive axis is logarithmic if the values span several
/// powers of ten.
enum class Drawing { none, view, linear, logarithmic, adaptive };

struct Quantity {
  const char* key;          ///< names the quantity in the report's data
  const char* csv_columns;  ///< separated by commas; empty if not in the CSV
  const char* unit;
  int components;  ///< of a vector along x, y, z, or 1
  Drawing drawing;
  const char* label;  ///< names the plot
  const char* meaning;
  std::optional<double> (*value)(const Instant& at, int component);

  bool is_in_csv() const { return *csv_columns != '\0'; }
  bool is_in_report() const { return drawing != Drawing::none; }
  bool is_plotted() const { return is_in_report() && drawing != Drawing::view; }
  bool is_error() const { return drawing == Drawing::logarithmic; }
};

/// Returns all quantities, in the order of the CSV's columns.
const std::vector<Quantity>& quantities();

/// Returns the quantities that are plotted, errors first.
std::vector<const Quantity*> plotted_quantities();

}  // namespace polhode::demos
