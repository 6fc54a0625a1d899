#pragma once

#include <benchmark/benchmark.h>

#include <vector>

namespace polhode::benchmarks {

/// The names of the counters that a benchmark reports, here and in the JSON.
namespace counters {
inline constexpr char kRatio[] = "ratio";  ///< median over the rounds of Polhode's time by Bullet's
inline constexpr char kRatioQuartile1[] = "ratio_q1";
inline constexpr char kRatioQuartile3[] = "ratio_q3";
inline constexpr char kPlainNs[] = "plain_ns";      ///< Bullet's median, ns per body and step
inline constexpr char kPolhodeNs[] = "polhode_ns";  ///< the same with Polhode
// Those of memory are not of a pile.
inline constexpr char kBytesPerBody[] = "bytes_per_body";
inline constexpr char kPlainBytesPerBody[] = "plain_bytes_per_body";
inline constexpr char kAllocationsPerStep[] = "allocations_per_step";
inline constexpr char kDiverged[] = "diverged";  ///< incidents, in all worlds: bodies that turn no more
}  // namespace counters

/// The value below which that fraction of the values lies, interpolated. Of at least one value.
double quantile(std::vector<double> values, double fraction);

/// Times of two contenders, taken in turns: a slow spell of the machine meets both of a round, so that the
/// ratio within a round says more than that of two medians.
class PairedTimes {
 public:
  /// ns per body and step.
  void add_round(double plain_ns, double polhode_ns);
  void report(benchmark::State& state) const;

 private:
  std::vector<double> plain_ns_;
  std::vector<double> polhode_ns_;
  std::vector<double> ratios_;
};

}  // namespace polhode::benchmarks
