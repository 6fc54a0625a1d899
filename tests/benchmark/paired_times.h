#pragma once

#include <benchmark/benchmark.h>

#include <vector>

namespace polhode::benchmarks {

/// Names of the counters that a benchmark reports, on the console and in JSON.
namespace counters {
inline constexpr char kRatio[] = "ratio";  ///< median over the rounds of Polhode's time divided by Bullet's
inline constexpr char kRatioQuartile1[] = "ratio_q1";
inline constexpr char kRatioQuartile3[] = "ratio_q3";
inline constexpr char kPlainNs[] = "plain_ns";      ///< Bullet's median, ns per body and step
inline constexpr char kPolhodeNs[] = "polhode_ns";  ///< Polhode's median, ns per body and step
// The memory counters are not reported for piles.
inline constexpr char kBytesPerBody[] = "bytes_per_body";
inline constexpr char kPlainBytesPerBody[] = "plain_bytes_per_body";
inline constexpr char kAllocationsPerStep[] = "allocations_per_step";
inline constexpr char kDiverged[] = "diverged";  ///< incidents in all worlds, one per diverged body
}  // namespace counters

/// Returns a quantile of at least one value, linearly interpolated.
double quantile(std::vector<double> values, double fraction);

/// Times of two contenders, interleaved so that noise affects both equally. The ratio within a round is
/// therefore more precise than the ratio of the two medians.
class PairedTimes {
 public:
  /// Takes ns per body and step.
  void add_round(double plain_ns, double polhode_ns);
  void report(benchmark::State& state) const;

 private:
  std::vector<double> plain_ns_;
  std::vector<double> polhode_ns_;
  std::vector<double> ratios_;
};

}  // namespace polhode::benchmarks
