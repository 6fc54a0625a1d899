// A run is recorded in a file and replayed to the bit.
#include "viewer/model/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "demos/compare/command.h"
#include "demos/support_files.h"
#include "demos/viewer/resolved_scenario.h"
#include "viewer/model/session.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

class RecordingFile : public testing::Test {
 protected:
  RecordingFile() {
    Simulation simulation(resolved_scenario("dzhanibekov"),
                          find_contenders({"exact", "matrix", "bullet:none"}));
    for (int step = 0; step < 60; ++step) simulation.step();  // the matrix diverges on the way
    write_recording(simulation, file_);
  }

  std::string error_of_replay() const {
    try {
      Session(read_recording(file_)).run_to(100);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_ / "run.txt";
};

TEST_F(RecordingFile, IsReplayedToTheBit) {
  EXPECT_EQ(read_recording(file_).steps(), 60);
  EXPECT_EQ(error_of_replay(), "");
}

TEST_F(RecordingFile, NamesTheStepInWhichAReplayLeavesIt) {
  Recording recording = read_recording(file_);
  recording.digests[17][2] ^= 1;
  Session session(recording);
  EXPECT_THROW(session.run_to(60), std::runtime_error);
  EXPECT_EQ(session.simulation().shown_step(), 17);
  session.apply(Action::reset);
  session.apply(Action::run_or_pause);
  for (int i = 0; i < 50; ++i) session.advance(0.1, std::chrono::seconds(60));
  EXPECT_FALSE(session.is_running());
  EXPECT_THAT(session.notice(), HasSubstr("differs from the recording in step 17 of bullet:none"));
}

TEST_F(RecordingFile, OfAnotherScenarioIsLeftAtOnce) {
  std::string text = read_file(file_);
  const std::string before = "\"dt\":0.03";
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos);
  write_file(file_, text.replace(at, before.size(), "\"dt\":0.0300000000001"));
  EXPECT_THAT(error_of_replay(), HasSubstr("differs from the recording in step 1 of exact"));
}

TEST_F(RecordingFile, ThatIsNoneIsRefused) {
  for (const char* text : {"", "{}", "[1]", "not json", "{\"format\": \"polhode recording 1\"}",
                           "{\"format\": \"polhode recording 1\", \"scenario\": 1, \"contenders\": [2]}"}) {
    write_file(file_, text);
    EXPECT_NE(error_of_replay(), "") << text;
  }
}

TEST_F(RecordingFile, ThatIsNoRegularFileIsRefused) {
  const std::string valid = "; valid is a file that polhode_viewer --record wrote";
  ASSERT_EQ(::mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  const std::vector<std::pair<std::filesystem::path, std::string>> refused = {
      {directory_ / "nothing", ": no such file"},
      {directory_.path(), ": not a regular file"},
      {directory_ / "pipe", ": not a regular file"},
      {"/dev/zero", ": not a regular file"}};
  for (const auto& file_and_reason : refused) {
    const std::filesystem::path& file = file_and_reason.first;
    EXPECT_THAT([&] { read_recording(file); }, testing::ThrowsMessage<std::invalid_argument>(
                                                   file.string() + file_and_reason.second + valid));
  }
}

double peak_megabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

TEST_F(RecordingFile, ThatIsHugeIsRefusedInLittleMemory) {
  const std::string whole = read_file(file_);
  const std::string header = whole.substr(0, whole.find('\n') + 1);
  const double before = peak_megabytes();
  for (const auto& [begin, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", "its first line has more than 8388608 bytes"},
           {header, "its line of step 0 is not one number per contender"},
           {whole, "its line of step 61 is not one number per contender"},
           {std::string(1000000, '['), "nested deeper than 16 levels"},
           {"{\"format\": " + std::string(1000000, '['), "nested deeper than 16 levels"},
           {header.substr(0, header.size() - 3) + ", \"a\": 1}}\n", "\"a\": unknown key"}}) {
    write_file(file_, begin);
    if (begin.size() < 1000000) std::filesystem::resize_file(file_, std::uintmax_t{2} << 30);  // with zeros
    EXPECT_THAT(error_of_replay(), HasSubstr(reason));
  }
  EXPECT_LT(peak_megabytes() - before, 50.0 * kMemoryFactor);  // measured 10
}

TEST_F(RecordingFile, OfAMillionStepsIsRead) {
  std::string text = read_file(file_);
  const std::string line = text.substr(text.rfind('\n', text.size() - 2) + 1);
  text.erase(text.find('\n') + 1);
  for (int step = 0; step <= 1000000; ++step) text += line;
  write_file(file_, text);
  EXPECT_EQ(read_recording(file_).steps(), 1000000);
  write_file(file_, text + line);
  EXPECT_THAT(error_of_replay(), HasSubstr("it has more than 1000000 steps"));
}

TEST_F(RecordingFile, ThatIsCutShortIsRefused) {
  const std::string text = read_file(file_);
  write_file(file_, text.substr(0, text.size() - 20));
  EXPECT_THAT(error_of_replay(), HasSubstr("its line of step 60 is not one number per contender"));
}

}  // namespace
}  // namespace polhode::demos
