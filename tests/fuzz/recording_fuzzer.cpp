// Reads recordings of the viewer. Rejected files must throw ScenarioError or std::invalid_argument. Replays
// the start of accepted recordings.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "demos/support_files.h"
#include "scenario/json_file.h"
#include "viewer/model/recording.h"
#include "viewer/model/session.h"

namespace polhode::demos {
namespace {

constexpr std::int64_t kSteps = 3;
constexpr std::size_t kHistory = 16;

void replay(const std::filesystem::path& file) {
  try {
    const Recording recording = read_recording(file);
    const std::int64_t last = std::min(recording.steps(), kSteps);
    Session session(recording, kHistory);
    session.run_to(last);
  } catch (const ScenarioError&) {
  } catch (const std::invalid_argument&) {
  } catch (const std::runtime_error&) {  // the step differs from the recorded one
  }
}

}  // namespace
}  // namespace polhode::demos

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode::demos;
  static const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "recording";
  write_file(file, std::string(reinterpret_cast<const char*>(data), size));
  replay(file);
  return 0;
}
