#pragma once

#include <string>
#include <vector>

#include "record/quantities.h"
#include "scenario/range.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

struct PlotPoint {
  double t_s;
  double value;  ///< of a logarithmic quantity its power of ten
};

/// The points of one contender, in the order of time; empty where the quantity is not known.
using Curve = std::vector<PlotPoint>;

/// What one plot shows: a quantity, or one component of a vector.
struct PlotSubject {
  const Quantity* quantity;
  int component;

  /// "energy, J"
  std::string title() const;
};

/// All that is plotted, errors first.
std::vector<PlotSubject> plot_subjects();

/// A curve for each contender, up to the step that is shown, of about `most_points` points.
std::vector<Curve> curves_of(const Simulation& simulation, const PlotSubject& subject,
                             std::size_t most_points);

/// Returns the range that shows all curves but the few that leave the others by far, such as one that blows
/// up.
Range value_range(const std::vector<Curve>& curves);

/// Returns true if a part of the curve is outside the range.
bool leaves(const Curve& curve, const Range& range);

/// Round numbers within a range, two to six of them.
std::vector<double> ticks(const Range& range);

}  // namespace polhode::demos
