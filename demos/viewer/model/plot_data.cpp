#include "viewer/model/plot_data.h"

#include <algorithm>
#include <cmath>

namespace polhode::demos {

namespace {

/// The least error drawn, below rounding.
constexpr double kLeastPower = -17.0;
/// The fraction of the curves, sorted by extent, that sets the range; other curves may extend kUsualReach
/// times as far.
constexpr double kUsualPart = 0.7;
constexpr double kUsualReach = 4.0;
/// The least range, relative to the initial value.
constexpr double kRoomToLeave = 0.3;
constexpr double kMargin = 0.08;

double shown_value(double value, bool is_error) {
  return is_error ? std::max(std::log10(std::abs(value)), kLeastPower) : value;
}

Curve curve_of(const ContenderRun& run, std::int64_t last_step, const PlotSubject& subject,
               std::size_t most_points) {
  const History& history = run.history();
  const std::int64_t last = std::min(last_step, history.last_step());
  const auto steps = std::max<std::int64_t>(1, last - history.first_step());
  const auto most = static_cast<std::int64_t>(most_points);
  const std::int64_t stride = std::max<std::int64_t>(1, (steps + most - 1) / most);
  Curve curve;
  // Takes multiples of the stride, so that a growing curve does not flicker, and the newest step.
  for (std::int64_t step = history.first_step(); step <= last;
       step = std::min(step == last ? last + 1 : last, (step / stride + 1) * stride)) {
    const Instant at = run.instant(step);
    const std::optional<double> value = subject.quantity->value(at, subject.component);
    if (value) curve.push_back({at.sample.t_s, shown_value(*value, subject.quantity->is_error())});
  }
  return curve;
}

Range extent(const Curve& curve) {
  const auto [lowest, highest] = std::minmax_element(
      curve.begin(), curve.end(), [](const PlotPoint& a, const PlotPoint& b) { return a.value < b.value; });
  return {lowest->value, highest->value};
}

/// Returns the largest distance from the first value, without the outliers.
double usual_distance(const std::vector<Range>& extents, double centre) {
  std::vector<double> distances;
  distances.reserve(extents.size());
  for (const Range& one : extents) {
    distances.push_back(std::max(std::abs(one.highest - centre), std::abs(one.lowest - centre)));
  }
  std::sort(distances.begin(), distances.end());
  const auto usual = static_cast<std::size_t>(kUsualPart * static_cast<double>(distances.size()));
  // If nearly all curves show rounding only, leaves room for one that departs from them.
  const double limit = std::max(kUsualReach * distances[usual], kRoomToLeave * std::abs(centre));
  if (distances[usual] < kRoomToLeave * std::abs(centre)) return std::min(limit, distances.back());
  return *(std::upper_bound(distances.begin() + static_cast<std::ptrdiff_t>(usual), distances.end(), limit) -
           1);
}

}  // namespace

std::string PlotSubject::title() const {
  const std::string axis = quantity->components == 3 ? std::string(" ") + "xyz"[component] : "";
  const std::string unit = quantity->unit == std::string("1") ? "no unit" : quantity->unit;
  return quantity->label + axis + ", " + unit;
}

std::vector<PlotSubject> plot_subjects() {
  std::vector<PlotSubject> subjects;
  for (const Quantity* quantity : plotted_quantities()) {
    for (int i = 0; i < quantity->components; ++i) subjects.push_back({quantity, i});
  }
  return subjects;
}

std::vector<Curve> curves_of(const Simulation& simulation, const PlotSubject& subject,
                             std::size_t most_points) {
  std::vector<Curve> curves;
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    curves.push_back(curve_of(simulation.run(index), simulation.shown_step(), subject, most_points));
  }
  return curves;
}

Range value_range(const std::vector<Curve>& curves) {
  std::vector<Range> extents;
  double centre = 0.0;
  for (const Curve& curve : curves) {
    if (curve.empty()) continue;
    if (extents.empty()) centre = curve.front().value;
    extents.push_back(extent(curve));
  }
  if (extents.empty()) return {0.0, 1.0};
  const double reach = usual_distance(extents, centre);
  Range shown{centre, centre};
  for (const Range& one : extents) {
    shown.lowest = std::min(shown.lowest, std::max(one.lowest, centre - reach));
    shown.highest = std::max(shown.highest, std::min(one.highest, centre + reach));
  }
  // A curve that varies by rounding only is drawn as a straight line.
  const double least = std::max(1e-5 * std::abs(centre), 1e-12);
  const double margin = std::max(kMargin * (shown.highest - shown.lowest), least);
  return {shown.lowest - margin, shown.highest + margin};
}

bool leaves(const Curve& curve, const Range& range) {
  return std::any_of(curve.begin(), curve.end(),
                     [&](const PlotPoint& point) { return !range.contains(point.value); });
}

std::vector<double> ticks(const Range& range) {
  const double span = range.highest - range.lowest;
  if (!(span > 0.0) || !std::isfinite(span)) return {};
  double step = std::pow(10.0, std::floor(std::log10(span)));
  for (const double factor : {0.5, 0.4, 0.5}) {
    if (span / step < 3.0) step *= factor;
  }
  while (span / step > 6.0) step *= 2.0;
  std::vector<double> result;
  const double first = std::ceil(range.lowest / step);
  for (double multiple = first; multiple * step <= range.highest && result.size() < 8; multiple += 1.0) {
    result.push_back(multiple * step + 0.0);  // avoids negative zero
  }
  return result;
}

}  // namespace polhode::demos
