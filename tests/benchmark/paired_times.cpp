#include "benchmark/paired_times.h"

#include <algorithm>
#include <cmath>

namespace polhode::benchmarks {

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

void PairedTimes::add_round(double plain_ns, double polhode_ns) {
  plain_ns_.push_back(plain_ns);
  polhode_ns_.push_back(polhode_ns);
  ratios_.push_back(polhode_ns / plain_ns);
}

void PairedTimes::report(benchmark::State& state) const {
  if (ratios_.empty()) return;
  state.counters[counters::kRatio] = quantile(ratios_, 0.5);
  state.counters[counters::kRatioQuartile1] = quantile(ratios_, 0.25);
  state.counters[counters::kRatioQuartile3] = quantile(ratios_, 0.75);
  state.counters[counters::kPlainNs] = quantile(plain_ns_, 0.5);
  state.counters[counters::kPolhodeNs] = quantile(polhode_ns_, 0.5);
}

}  // namespace polhode::benchmarks
