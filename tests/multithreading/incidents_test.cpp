// Incidents are reported in the thread that called stepSimulation, whatever thread rotates the body.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "multithreading/plays.h"

namespace polhode::testing {
namespace {

class IncidentsInMt : public ::testing::TestWithParam<Way> {
 protected:
  Outcome run_with_four_threads() const {
    return run(free_bodies(), GetParam(), {true, true}, four_threads());
  }
};

std::size_t count(const Outcome& outcome, IncidentKind kind) {
  return static_cast<std::size_t>(
      std::count_if(outcome.incidents.begin(), outcome.incidents.end(),
                    [kind](const ToldIncident& incident) { return incident.kind == kind; }));
}

TEST_P(IncidentsInMt, AreToldInTheThreadOfTheCallerOnly) {
  const Outcome result = run_with_four_threads();
  EXPECT_EQ(result.threads_of_handler, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST_P(IncidentsInMt, AreToldOnceForEachBodyAndKindInTheOrderOfTheBodies) {
  const Outcome result = run_with_four_threads();
  std::set<std::pair<IncidentKind, std::size_t>> told;
  for (const ToldIncident& incident : result.incidents) {
    EXPECT_TRUE(told.emplace(incident.kind, incident.body).second) << "body " << incident.body;
  }
  const auto earlier = [](const ToldIncident& a, const ToldIncident& b) {
    return std::make_tuple(a.step, a.body) < std::make_tuple(b.step, b.body);
  };
  EXPECT_TRUE(std::is_sorted(result.incidents.begin(), result.incidents.end(), earlier));
  // Enough incidents for the order to matter.
  EXPECT_GE(count(result, IncidentKind::non_finite_body), 5u);    // measured 5
  EXPECT_GE(count(result, IncidentKind::scheme_diverged), 100u);  // measured 224
}

INSTANTIATE_TEST_SUITE_P(FourThreads, IncidentsInMt,
                         ::testing::Values(Way::rotation_world, Way::rotation_plugin),
                         [](const auto& parameter) { return to_string(parameter.param); });

}  // namespace
}  // namespace polhode::testing
