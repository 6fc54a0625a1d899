// Scenario files that would need all memory or much time are refused in one line, or handled with little of
// both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <thread>

#include "demos/compare/command.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

constexpr double kMostSeconds = 10.0;     // measured 1.6 at most; under AddressSanitizer 22 on a busy machine
constexpr double kMostMegabytes = 100.0;  // measured 50 at most

const std::string kFreeBody =
    R"("inertia": [1, 2, 3], "angular_velocity": [1, 2, 3], "dt": 0.1, "duration": 1)";

std::string times(int count, const std::string& text) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string list_of(int count, const std::string& element) {
  return "[" + element + times(count - 1, "," + element) + "]";
}

std::string many_keys(int count) {
  std::string keys;
  for (int i = 0; i < count; ++i) keys += ",\"" + std::to_string(i) + "\":0";
  return keys;
}

struct HostileFile {
  std::string what;
  std::string (*text)();  ///< made on demand, since the memory of this process counts
  std::string message;
};

std::ostream& operator<<(std::ostream& stream, const HostileFile& file) {
  return stream << file.what;
}

class HostileScenario : public testing::TestWithParam<HostileFile> {
 protected:
  TemporaryDirectory directory_;
};

TEST_P(HostileScenario, IsRefusedInLittleMemoryAndTime) {
  const std::filesystem::path file = directory_ / "hostile.json";
  write_file(file, GetParam().text());
  if (std::filesystem::file_size(file) == 0) std::filesystem::resize_file(file, std::uintmax_t{2} << 30);
  const CommandResult result = Command(POLHODE_COMPARE_EXECUTABLE, {"--scenario", file.string()}).wait();
  expect_refused_in_one_line(result);
  EXPECT_EQ(result.standard_output, "");
  EXPECT_THAT(result.standard_error, HasSubstr("hostile.json: " + GetParam().message));
  EXPECT_LT(result.standard_error.size(), 1000u);
  EXPECT_LT(result.peak_megabytes, kMostMegabytes * kMemoryFactor);
  EXPECT_LT(result.processor_seconds, kMostSeconds * kTimeFactor);
}

/// Returns a free body with more keys.
std::string body_with(const std::string& more) {
  return "{" + kFreeBody + more + "}";
}

const char* const kOther = R"({"inertia":[1,1,1]})";
const std::string kTooDeep = "lists and objects are nested deeper than 16 levels";

const HostileFile kHostileFiles[] = {
    {"two_gigabytes", [] { return std::string(); },
     "has more than 1048576 bytes; a scenario is a JSON file of at most 1048576 bytes"},
    {"million_bodies", [] { return body_with(",\"others\":" + list_of(1000000, kOther)); },
     "has more than 1048576 bytes"},
    {"bodies_up_to_the_size", [] { return body_with(",\"others\":" + list_of(50000, kOther)); },
     "\"others\": makes it 50001 shapes in total"},
    {"parts_up_to_the_size",
     [] {
       return R"({"dt":0.1,"duration":1,"shape":{"type":"compound","parts":)" +
              list_of(30000, R"({"half_extents":[1,1,1],"mass":1})") + "}}";
     },
     "\"shape\": makes it 30000 shapes in total"},
    {"million_brackets", [] { return times(1000000, "["); }, kTooDeep},
    {"deep_objects", [] { return times(170000, R"({"a":)"); }, kTooDeep},
    {"deep_value", [] { return body_with(",\"mass\":" + times(500000, "[") + times(500000, "]")); },
     kTooDeep},
    {"long_list", [] { return body_with(",\"mass\":" + list_of(500000, "0")); },
     "\"mass\": must be a finite number"},
    {"many_keys", [] { return body_with(many_keys(90000)); }, "\"0\": unknown key"},
    {"key_twice", [] { return body_with(many_keys(90000) + ",\"89999\":0"); },
     "\"89999\": the key is given twice"},
    {"long_text", [] { return body_with(",\"name\":\"" + times(1000000, "a") + "\""); },
     "\"name\": must be a text of at most 1024 bytes, has 1000000"},
    {"long_number", [] { return body_with(",\"mass\":" + times(1000000, "9")); },
     "\"mass\": number overflow parsing '99"}};

INSTANTIATE_TEST_SUITE_P(Each, HostileScenario, testing::ValuesIn(kHostileFiles),
                         [](const auto& file) { return file.param.what; });

// The most expensive valid scenario: every pair of bodies overlaps.
TEST(HostileScenario, OfAsManyBodiesAsAreValidIsRunInBoundedMemory) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "crowd.json").string();
  write_file(file, body_with(",\"others\":" + list_of(199, kOther)));
  const CommandResult result =
      Command(POLHODE_COMPARE_EXECUTABLE, {"--scenario", file, "--contender", "exact"}).wait();
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_LT(result.peak_megabytes, 150.0 * kMemoryFactor);  // measured 65
}

CommandResult in_shell(const std::string& command) {
  return Command("/bin/bash", {"-c", "set -o pipefail; compare=" POLHODE_COMPARE_EXECUTABLE "; " + command})
      .wait();
}

TEST(ScenarioFromAPipe, IsReadLikeOneFromAFile) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "mine.json").string();
  write_file(file, "{" + kFreeBody + ",\"name\":\"mine\"}");
  for (const std::string& command :
       {"$compare --scenario <(cat " + file + ")", "$compare --scenario <(sleep 0.2; cat " + file + ")",
        "cat " + file + " | $compare --scenario /dev/stdin", "$compare --scenario /dev/stdin < " + file}) {
    const CommandResult result = in_shell(command + " --contender exact");
    EXPECT_EQ(result.exit_code, 0) << command << ": " << result.standard_error;
    EXPECT_THAT(result.standard_output, testing::StartsWith("mine\n"));
  }
}

TEST(ScenarioFromAPipe, IsRefusedWhereItHasNoEnd) {
  const CommandResult result = in_shell("$compare --scenario <(cat /dev/zero)");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.standard_error, HasSubstr(": has more than 1048576 bytes"));
  EXPECT_LT(result.peak_megabytes, kMostMegabytes * kMemoryFactor);
  EXPECT_LT(result.processor_seconds, kMostSeconds * kTimeFactor);
}

TEST(ScenarioFromAPipe, IsNotWaitedForAfterASignal) {
  const TemporaryDirectory directory;
  const std::string pipe = (directory / "pipe.json").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Command command(POLHODE_COMPARE_EXECUTABLE,
                  {"--scenario", pipe, "--csv", (directory / "out.csv").string()});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  command.send_signal(SIGTERM);
  const CommandResult result = command.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_THAT(result.standard_error, HasSubstr("pipe.json: cannot be read: Interrupted system call"));
  EXPECT_EQ(directory.file_count(), 1) << "the pipe";
}

}  // namespace
}  // namespace polhode::demos
