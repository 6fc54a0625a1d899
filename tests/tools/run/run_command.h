#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "demos/compare/command.h"

/// Runs programs with and without polhode-run.
namespace polhode::run_test {

using demos::CommandResult;

// AddressSanitizer normally insists on being the first library loaded. The C library fills freed memory, so
// that its use shows.
inline const std::vector<std::string> kEnvironment = {"ASAN_OPTIONS=verify_asan_link_order=0", "LD_PRELOAD",
                                                      "MALLOC_PERTURB_=165"};

inline CommandResult run_plainly(const std::string& program, const std::vector<std::string>& arguments) {
  return demos::Command(program, arguments, kEnvironment).wait();
}

/// `words`: options, program, arguments.
inline CommandResult run(const std::vector<std::string>& words) {
  return run_plainly(POLHODE_RUN_EXECUTABLE, words);
}

/// Returns the energy ratios that a host printed.
inline std::vector<double> energy_ratios(const CommandResult& result) {
  std::vector<double> ratios;
  std::istringstream lines(result.standard_output);
  const std::string label = "energy ratio ";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(label, 0) == 0) ratios.push_back(std::atof(line.c_str() + label.size()));
  }
  return ratios;
}

/// A host program for one of Bullet's precisions.
struct Host {
  const char* precision;
  const char* program;
  const char* hidden_worlds;
  double energy_tolerance;
};

inline std::vector<Host> hosts() {
  std::vector<Host> list;
#ifdef POLHODE_HOST32
  list.push_back({"single", POLHODE_HOST32, POLHODE_HIDDEN_WORLDS32, 4e-7});  // measured 1.8e-7
#endif
#ifdef POLHODE_HOST64
  list.push_back({"double", POLHODE_HOST64, POLHODE_HIDDEN_WORLDS64, 1e-15});  // measured 2.2e-16
#endif
  return list;
}

inline void expect_energy_kept(const CommandResult& result, std::size_t worlds, double tolerance) {
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  const std::vector<double> ratios = energy_ratios(result);
  EXPECT_EQ(ratios.size(), worlds);
  for (const double ratio : ratios) EXPECT_LT(std::abs(ratio - 1.0), tolerance);
}

/// Bullet itself loses a sixth of the energy in this scene.
inline void expect_energy_lost(const CommandResult& result) {
  const std::vector<double> ratios = energy_ratios(result);
  ASSERT_EQ(ratios.size(), 1u) << result.standard_error;
  EXPECT_NEAR(ratios[0], 0.832, 0.001);  // measured 0.83219 in both precisions
}

}  // namespace polhode::run_test
