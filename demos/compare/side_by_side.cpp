#include "compare/side_by_side.h"

#include "world/body_shape.h"
#include "world/run.h"

namespace polhode::demos {

Report run_side_by_side(const Scenario& scenario, const ChosenContenders& chosen, const std::string& command,
                        const ContenderObserver& observe) {
  const Scenario run_as = resolved(scenario);
  Report report{{run_as, bullet_precision(), {}, chosen.note}, {}, {}, drawn_body(run_as.body), command};
  const std::int64_t steps = step_count(run_as.dt, run_as.duration);
  for (std::size_t i = 0; i < chosen.contenders.size(); ++i) {
    const Contender& contender = chosen.contenders[i];
    SeriesRecorder series(*run_as.body.inertia_B, run_as.dt, steps, most_records(chosen.contenders.size()));
    const Figures figures = run(run_as, contender, [&](const Sample& sample) {
      observe(i, sample);
      series.add(sample);
    });
    report.comparison.contenders.push_back({contender.name, figures});
    report.summaries.push_back(contender.summary);
    report.series.push_back(series.finish());
  }
  return report;
}

}  // namespace polhode::demos
