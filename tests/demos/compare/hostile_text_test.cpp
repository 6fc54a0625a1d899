// Texts that a terminal, a spreadsheet or a browser would obey, in every place where polhode_compare accepts
// a text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "demos/compare/command.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Clears the screen, sets the clipboard, sets a title in C1, starts a new line, reverses the writing
/// direction, and is not UTF-8.
const std::string kHostile =
    "=1+1,\"<img src=x onerror=alert(1)>\x1b[2J\x1b]52;c;eA==\x07\r\n\x7f\u009d0;t\u009c\u202e\xff";
const std::string kEscaped =
    "=1+1,\"<img src=x "
    "onerror=alert(1)>\\x1b[2J\\x1b]52;c;eA==\\x07\\x0d\\x0a\\x7f\\xc2\\x9d0;t\\xc2\\x9c\\xe2\\x80\\xae"
    "\\xff";
const std::string kBody = R"("inertia": [1, 2, 3], "angular_velocity": [1, 2, 3], "dt": 0.1, "duration": 1)";

void expect_harmless(const std::string& text) {
  for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << text;
}

CommandResult run_compare(const std::vector<std::string>& arguments,
                          const std::vector<std::string>& environment = {}) {
  CommandResult result = Command(POLHODE_COMPARE_EXECUTABLE, arguments, environment).wait();
  expect_harmless(result.standard_output);
  expect_harmless(result.standard_error);
  return result;
}

void expect_one_line_that_shows_the_text(const CommandResult& result) {
  expect_refused_in_one_line(result);
  EXPECT_EQ(result.standard_output, "");
  EXPECT_THAT(result.standard_error, HasSubstr(kEscaped));
}

class HostileText : public testing::Test {
 protected:
  std::string write_scenario(const std::string& name, const std::string& text) const {
    write_file(directory_ / name, text);
    return (directory_ / name).string();
  }

  TemporaryDirectory directory_;
};

/// File names cannot contain a slash; this one has the rest.
const std::string kFileName = kHostile + ".json";

TEST_F(HostileText, OnTheCommandLineIsShownEscaped) {
  const std::string file = (directory_ / kHostile / "out").string();
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{kHostile},
                                             {"--x" + kHostile},
                                             {"--scenario", kHostile},
                                             {"--scenario", "./" + kFileName},
                                             {"--contender", kHostile},
                                             {"--dt", kHostile},
                                             {"--duration", kHostile},
                                             {"--csv", file},
                                             {"--csv", file, "--json", file}}) {
    expect_one_line_that_shows_the_text(run_compare(arguments));
  }
  expect_one_line_that_shows_the_text(run_compare({"--list"}, {"POLHODE_SCENARIOS=/" + kHostile}));
}

TEST_F(HostileText, OfTheProgramsOwnNameIsShownEscaped) {
  const std::filesystem::path link = directory_ / kHostile;
  std::filesystem::create_symlink(POLHODE_COMPARE_EXECUTABLE, link);
  for (const std::string option : {"--help", "--version", "--frobnicate"}) {
    const CommandResult result = Command(link, {option}).wait();
    expect_harmless(result.standard_output);
    expect_harmless(result.standard_error);
    EXPECT_EQ(result.exit_code, option == "--frobnicate" ? 2 : 0);
  }
}

TEST_F(HostileText, InAFileIsShownEscaped) {
  const nlohmann::json key = kHostile.substr(0, kHostile.size() - 1);  // of UTF-8
  for (const std::string& text :
       {"{" + kBody + ", " + key.dump() + ": 1}", "{" + kBody + ", \"name\": " + key.dump() + "}",
        "{" + kBody + ", \"shape\": {\"type\": " + key.dump() + "}}",
        "{" + kBody + ", \"mass\": " + key.dump() + "}", "{" + key.dump() + ": 1, " + key.dump() + ": 2}",
        "{" + key.dump() + ": 1e999}", "{\"" + kHostile + "\": 1}", kHostile}) {
    const CommandResult result = run_compare({"--scenario", write_scenario(kFileName, text)});
    expect_one_line_that_shows_the_text(result);  // the file's name
    std::string rest = result.standard_error;
    rest.erase(0, rest.find(".json: ") + 7);
    EXPECT_LT(rest.size(), 500u) << rest;  // measured 347, with all valid keys
  }
}

TEST_F(HostileText, OfALongKeyOrNumberIsShortened) {
  const std::string long_text(900000, '9');
  const std::string key = ", \"" + long_text + "\": ";
  for (const std::string& more :
       {key + "1", ", \"mass\": " + long_text, ", \"mass\": \"" + long_text + "\"",
        ", \"name\": \"" + long_text + "\"", ", \"mass\": x" + long_text,
        std::string(key).append("1").append(key).append("2"), ", \"mass\": \"" + long_text + "\xff\""}) {
    const std::string scenario = std::string("{").append(kBody).append(more).append("}");
    const CommandResult result = run_compare({"--scenario", write_scenario("long.json", scenario)});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_LT(result.standard_error.size(), 600u);  // measured 411, with all valid keys
  }
}

// A scenario without a "name" is named after its file.
TEST_F(HostileText, OfAFileNameBecomesAHarmlessName) {
  write_scenario(kFileName, "{" + kBody + "}");
  const std::string json = (directory_ / "out.json").string();
  const std::string csv = (directory_ / "out.csv").string();
  const std::string report = (directory_ / "out.html").string();
  const CommandResult result = run_compare({"--scenario", (directory_ / kFileName).string(), "--contender",
                                            "exact", "--json", json, "--csv", csv, "--report", report});
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_THAT(result.standard_output, testing::StartsWith(kEscaped + "\ndt 0.1 s"));
  expect_harmless(read_file(json));
  const nlohmann::json scenario = nlohmann::json::parse(read_file(json))["scenario"];
  EXPECT_EQ(scenario["name"], kEscaped);
  EXPECT_THAT(read_file(csv), Not(HasSubstr("=1")));
  EXPECT_THAT(read_file(report), Not(HasSubstr("<img src=x")));
  // The output is a valid scenario again.
  EXPECT_EQ(run_compare({"--scenario", write_scenario("again.json", scenario.dump()), "--contender", "exact"})
                .exit_code,
            0);
  EXPECT_THAT(run_compare({"--list"}, {"POLHODE_SCENARIOS=" + directory_.path().string()}).standard_error,
              HasSubstr("out.json"))
      << "which is none";
  std::filesystem::remove(json);
  const CommandResult list = run_compare({"--list"}, {"POLHODE_SCENARIOS=" + directory_.path().string()});
  EXPECT_THAT(list.standard_output, HasSubstr("\n" + kEscaped + "\n"));
}

TEST_F(HostileText, InTheCommandOfAReportCanBeRunAgain) {
  const std::string file = write_scenario(kFileName, "{" + kBody + "}");
  const std::string report = (directory_ / "out.html").string();
  ASSERT_EQ(run_compare({"--scenario", file, "--contender", "exact", "--report", report}).exit_code, 0);
  const std::string page = read_file(report);
  const std::size_t begin = page.find("\"command\":") + 10;
  const std::string command =
      nlohmann::json::parse(page.substr(begin, page.find(",\"scenario\":", begin) - begin));
  expect_harmless(command);
  EXPECT_THAT(
      command,
      HasSubstr(
          "\\033[2J\\033]52;c;eA==\\007\\015\\012\\177\\302\\2350;t\\302\\234\\342\\200\\256\\377.json'"));
  std::filesystem::remove(report);
  const std::string folder = std::filesystem::path(POLHODE_COMPARE_EXECUTABLE).parent_path().string();
  EXPECT_EQ(Command("/bin/bash", {"-c", "PATH=" + folder + "; " + command}).wait().exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(report));
}

}  // namespace
}  // namespace polhode::demos
