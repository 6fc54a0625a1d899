#pragma once

#include <string>
#include <vector>

#include "record/quantities.h"
#include "scenario/range.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

struct PlotPoint {
  double t_s;
  double value;  ///< a power of ten for a logarithmic quantity
};

/// The points of one contender, ordered by time; empty if the quantity is unknown.
using Curve = std::vector<PlotPoint>;

/// The content of a plot: a quantity, or one component of a vector.
struct PlotSubject {
  const Quantity* quantity;
  int component;

  /// Returns for example "energy, J".
  std::string title() const;
};

/// Returns all plots, errors first.
std::vector<PlotSubject> plot_subjects();

/// Returns a curve of about `most_points` points for each contender, up to the step shown.
std::vector<Curve> curves_of(const Simulation& simulation, const PlotSubject& subject,
                             std::size_t most_points);

/// Returns the range that shows all curves except a few that leave the others far behind, such as one that
/// blows up.
Range value_range(const std::vector<Curve>& curves);

/// Returns true if part of the curve is outside the range.
bool leaves(const Curve& curve, const Range& range);

/// Returns two to six round numbers within a range.
std::vector<double> ticks(const Range& range);

}  // namespace polhode::demos
