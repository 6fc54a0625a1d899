#include "viewer/model/csv_export.h"

#include <algorithm>

#include "record/csv.h"
#include "record/output_file.h"

namespace polhode::demos {

void export_csv(const Simulation& simulation, const std::filesystem::path& file) {
  OutputFile output(file);
  output.write(csv_header());
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    const ContenderRun& run = simulation.run(index);
    const std::int64_t last = std::min(run.history().last_step(), simulation.shown_step());
    for (std::int64_t step = run.history().first_step(); step <= last; ++step) {
      output.write(csv_row(run.contender().name, run.instant(step)));
    }
  }
  output.commit();
}

}  // namespace polhode::demos
