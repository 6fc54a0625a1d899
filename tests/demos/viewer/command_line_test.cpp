// polhode_viewer as a program: bad input, and pictures without a display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <set>

#include "demos/compare/command.h"
#include "record/contender.h"
#include "viewer/model/palette.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

CommandResult run_viewer(const std::vector<std::string>& arguments) {
  return Command(POLHODE_VIEWER_EXECUTABLE, arguments,
                 {"DISPLAY=", "WAYLAND_DISPLAY=", "EGL_PLATFORM=surfaceless", "LIBGL_ALWAYS_SOFTWARE=1"})
      .wait();
}

/// The number of pixels of each colour, 0xRRGGBB.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<int> colors;

  std::ptrdiff_t count(Color color) const {
    return std::count(colors.begin(), colors.end(), color.red << 16 | color.green << 8 | color.blue);
  }
};

Picture read_picture(const std::filesystem::path& file) {
  Picture picture;
  int channels = 0;
  unsigned char* pixels = stbi_load(file.c_str(), &picture.width, &picture.height, &channels, 3);
  if (pixels == nullptr) return picture;
  for (int i = 0; i < picture.width * picture.height; ++i) {
    picture.colors.push_back(pixels[3 * i] << 16 | pixels[3 * i + 1] << 8 | pixels[3 * i + 2]);
  }
  stbi_image_free(pixels);
  return picture;
}

/// Returns the arguments for the kept pictures. Pass them to polhode_viewer to make new ones.
std::vector<std::string> golden_arguments(const std::string& scenario, const std::string& file) {
  return {"--scenario", scenario,      "--contender",  "exact", "--contender", "matrix",
          "--at",       "0.25",        "--width",      "640",   "--height",    "320",
          "--teaching", "--no-panels", "--screenshot", file};
}

/// Returns the fraction of pixels that differ by more than antialiasing can explain.
double part_that_differs(const Picture& a, const Picture& b) {
  constexpr int kMostOfAChannel = 48;
  int differing = 0;
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    for (const int shift : {0, 8, 16}) {
      if (std::abs((a.colors[i] >> shift & 255) - (b.colors[i] >> shift & 255)) <= kMostOfAChannel) continue;
      ++differing;
      break;
    }
  }
  return differing / static_cast<double>(a.colors.size());
}

class PictureOf : public testing::TestWithParam<const char*> {};

TEST_P(PictureOf, AScenarioIsDrawnWithoutADisplay) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "out.png").string();
  const CommandResult result = run_viewer(
      {"--scenario", GetParam(), "--at", "0.2", "--screenshot", file, "--width", "1200", "--height", "800"});
  ASSERT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_EQ(result.standard_error, "");
  const Picture picture = read_picture(file);
  EXPECT_EQ(picture.width, 1200);
  EXPECT_EQ(picture.height, 800);
  EXPECT_GT(std::set<int>(picture.colors.begin(), picture.colors.end()).size(), 500u);
  for (std::size_t index = 0; index < default_contenders().size(); ++index) {
    EXPECT_GE(picture.count(contender_color(index)), 100) << "contender " << index;  // its chip: 13 x 13
  }
}

TEST_P(PictureOf, AScenarioIsLikeTheOneThatIsKept) {
  const TemporaryDirectory directory;
  const CommandResult result = run_viewer(golden_arguments(GetParam(), (directory / "out.png").string()));
  ASSERT_EQ(result.exit_code, 0) << result.standard_error;
  const Picture drawn = read_picture(directory / "out.png");
  const Picture kept = read_picture(std::string(POLHODE_VIEWER_PICTURES) + "/" + GetParam() + ".png");
  ASSERT_EQ(drawn.colors.size(), kept.colors.size());
  EXPECT_LT(part_that_differs(drawn, kept), 0.01);  // measured 0 on the machine where they were made
}

INSTANTIATE_TEST_SUITE_P(Viewer, PictureOf,
                         testing::Values("cube_expansion", "dzhanibekov", "fast_spinner", "floor",
                                         "heavy_top", "t_handle", "tumble"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Viewer, DrawsTheSamePictureTwice) {
  const TemporaryDirectory directory;
  for (const char* name : {"one.png", "two.png"}) {
    ASSERT_EQ(
        run_viewer({"--teaching", "--no-panels", "--at", "1", "--screenshot", (directory / name).string()})
            .exit_code,
        0);
  }
  EXPECT_EQ(read_file(directory / "one.png"), read_file(directory / "two.png"));
}

TEST(Viewer, SaysThatThereIsNoDisplay) {
  const CommandResult result = run_viewer({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.standard_error, HasSubstr("without a display valid is --screenshot FILE.png"));
}

TEST(Viewer, RefusesBadInputInOneLine) {
  const std::pair<std::vector<std::string>, std::string> inputs[] = {
      {{"--frobnicate"}, "valid options are"},
      {{"--scenario", "tumbler"}, "valid are bicycle_wheel, cube_expansion, dzhanibekov"},
      {{"--contender", "exakt"}, "exact"},
      {{"--replay", "\x1b[2J\u202e\xff\n"}, "\\x1b[2J\\xe2\\x80\\xae\\xff\\x0a: "},
      {{"--dt", "0"}, "--dt: must be a finite number between 1e-06 and 1000"},
      {{"--at", "-1"}, "--at: must be a finite number between 0 and 1e+09"},
      {{"--at", "1e9", "--screenshot", "x.png"}, "more than 1e+06 steps"},
      {{"--speed", "fast"}, "--speed: must be"},
      {{"--width", "1"}, "--width: must be a whole number between 200 and 8192"},
      {{"--through-window"}, "valid only with --screenshot"},
      {{"--screenshot", "/nowhere/x.png"}, "valid is a file in an existing, writable directory"}};
  for (const auto& [arguments, valid] : inputs) {
    const CommandResult result = run_viewer(arguments);
    SCOPED_TRACE(valid);
    expect_refused_in_one_line(result);
    EXPECT_EQ(result.standard_output, "");
    EXPECT_THAT(result.standard_error, testing::StartsWith("polhode_viewer: "));
    EXPECT_THAT(result.standard_error, HasSubstr(valid));
  }
}

}  // namespace
}  // namespace polhode::demos
