// A run in a file, and again to the bit.
#include "viewer/model/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "demos/support_files.h"
#include "demos/viewer/resolved_scenario.h"
#include "scenario/json_file.h"
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
  EXPECT_THAT(session.notice(), HasSubstr("leaves the recording in step 17 of bullet:none"));
}

TEST_F(RecordingFile, OfAnotherScenarioIsLeftAtOnce) {
  std::string text = read_file(file_);
  const std::string before = "\"dt\":0.03";
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos);
  write_file(file_, text.replace(at, before.size(), "\"dt\":0.0300000000001"));
  EXPECT_THAT(error_of_replay(), HasSubstr("leaves the recording in step 1 of exact"));
}

TEST_F(RecordingFile, ThatIsNoneIsRefused) {
  for (const char* text : {"", "{}", "[1]", "not json", "{\"format\": \"polhode recording 1\"}",
                           "{\"format\": \"polhode recording 1\", \"scenario\": 1, \"contenders\": [2]}"}) {
    write_file(file_, text);
    EXPECT_NE(error_of_replay(), "") << text;
  }
  EXPECT_THROW(read_recording(directory_ / "nothing"), ScenarioError);
}

TEST_F(RecordingFile, ThatIsCutShortIsRefused) {
  const std::string text = read_file(file_);
  write_file(file_, text.substr(0, text.size() - 20));
  EXPECT_THAT(error_of_replay(), HasSubstr("its line of step 60 is not one number per contender"));
}

}  // namespace
}  // namespace polhode::demos
