#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "demos/compare/command.h"

/// The programs and the files that they write, for tests of external faults.
namespace polhode::demos {

struct Writer {
  const char* name;
  const char* program;
  std::vector<std::string> arguments;  ///< the last one names the file option, whose value is added
  bool has_journal = false;            ///< keeps finished work in FILE.partial and resumes from it
  bool is_reproducible = true;         ///< false if the file contains measured times
};

inline void PrintTo(const Writer& writer, std::ostream* stream) {
  *stream << writer.name;
}

inline const std::vector<std::string> kWithoutDisplay = {
    "DISPLAY", "WAYLAND_DISPLAY", "EGL_PLATFORM=surfaceless", "LIBGL_ALWAYS_SOFTWARE=1"};

inline std::vector<Writer> writers() {
  std::vector<Writer> list;
#ifdef POLHODE_COMPARE_EXECUTABLE
  const std::vector<std::string> comparison = {"--contender", "exact", "--contender", "quaternion"};
  for (const char* option : {"--csv", "--json", "--report"}) {
    Writer writer = {option, POLHODE_COMPARE_EXECUTABLE, comparison};
    writer.arguments.emplace_back(option);
    writer.is_reproducible = writer.arguments.back() == "--csv";
    list.push_back(writer);
  }
  list[0].name = "ComparisonAsCsv";
  list[1].name = "ComparisonAsJson";
  list[2].name = "ComparisonAsReport";
  // Small enough to be written only when the file is closed.
  list.push_back({"ShortComparison",
                  POLHODE_COMPARE_EXECUTABLE,
                  {"--scenario", "tumble", "--duration", "0.3", "--contender", "exact", "--csv"}});
#endif
#ifdef POLHODE_WORKPRECISION_EXECUTABLE
  const char* work_precision = POLHODE_WORKPRECISION_EXECUTABLE;
  list.push_back({"Costs", work_precision, {"cost", "--rounds", "1", "--json"}, false, false});
  list.push_back(
      {"Curves", work_precision, {"curve", "--rounds", "1", "--levels", "2", "--csv"}, false, false});
  list.push_back({"Map",
                  work_precision,
                  {"map", "--scheme", "exact", "--scheme", "rk4", "--omega-dt", "0.05", "2", "12",
                   "--inertia-ratio", "1.2", "5", "5", "--steps", "5000", "--threads", "1", "--csv"},
                  true});
  list.push_back(
      {"Joints",
       work_precision,
       {"joints", "--kind", "hinge", "--omega-dt", "0.1", "1",      "3", "--inertia-ratio", "2", "3",
        "2",      "--tilt", "0",     "1",          "2",   "--time", "2", "--threads",       "1", "--csv"},
       true});
#endif
#ifdef POLHODE_VIEWER_EXECUTABLE
  list.push_back({"Picture", POLHODE_VIEWER_EXECUTABLE, {"--at", "0.5", "--screenshot"}});
  list.push_back(
      {"Recording",
       POLHODE_VIEWER_EXECUTABLE,
       {"--at", "5", "--width", "200", "--height", "200", "--screenshot", "OTHER.png", "--record"}});
#endif
  return list;
}

inline std::vector<Writer> writers(bool with_journal) {
  std::vector<Writer> list;
  for (const Writer& writer : writers()) {
    if (writer.has_journal == with_journal) list.push_back(writer);
  }
  return list;
}

/// A writer, a directory for its file, and one for its other output.
class WriterTest : public testing::TestWithParam<Writer> {
 protected:
  void SetUp() override {
    if (!can_run()) GTEST_SKIP() << "no OpenGL without a display";
  }

  Command start(const std::function<void()>& prepare = [] {}) const { return start_with(target(), prepare); }
  Command start_with(const std::filesystem::path& file, const std::function<void()>& prepare) const {
    std::vector<std::string> arguments = GetParam().arguments;
    for (std::string& argument : arguments) {
      if (argument == "OTHER.png") argument = (beside_ / "other.png").string();
    }
    arguments.push_back(file.string());
    return Command(GetParam().program, arguments, kWithoutDisplay, prepare);
  }
  std::filesystem::path target() const { return directory_ / "out"; }
  std::filesystem::path journal() const { return directory_ / "out.partial"; }
  /// Returns the output of an undisturbed run.
  std::string clean_text() const {
    EXPECT_EQ(start().wait().exit_code, 0);
    const std::string text = read_file(target());
    std::filesystem::remove(target());
    return text;
  }
  /// Counts the files besides the target that a run may leave when it ends early.
  int kept_files() const { return std::filesystem::exists(journal()) && GetParam().has_journal ? 1 : 0; }

  TemporaryDirectory directory_;
  TemporaryDirectory beside_;

 private:
  // False if no picture can be drawn here.
  bool can_run() const {
    const CommandResult result = start().wait();
    if (result.exit_code == 2 && result.standard_error.find("no OpenGL") != std::string::npos) return false;
    EXPECT_EQ(result.exit_code, 0) << result.standard_error;
    return true;
  }
};

inline std::string name_of(const testing::TestParamInfo<Writer>& test) {
  return test.param.name;
}

}  // namespace polhode::demos
