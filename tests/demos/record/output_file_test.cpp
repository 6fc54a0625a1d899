#include "record/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>

#include "demos/support_files.h"

namespace polhode::demos {
namespace {

TEST(OutputFile, AppearsWholeWhenItIsCommitted) {
  const TemporaryDirectory directory;
  const std::filesystem::path target = directory / "out.csv";
  {
    OutputFile file(target);
    file.write("one\n");
    file.write("two\n");
    EXPECT_FALSE(std::filesystem::exists(target));
    file.commit();
  }
  EXPECT_EQ(read_file(target), "one\ntwo\n");
  EXPECT_EQ(directory.file_count(), 1);
}

TEST(OutputFile, LeavesNothingWithoutACommit) {
  const TemporaryDirectory directory;
  {
    OutputFile file(directory / "out.csv");
    file.write("half");
    EXPECT_EQ(directory.file_count(), 1);
  }
  EXPECT_EQ(directory.file_count(), 0);
}

TEST(OutputFile, KeepsWhatWasThereWithoutACommit) {
  const TemporaryDirectory directory;
  write_file(directory / "out.csv", "before");
  { OutputFile(directory / "out.csv").write("half"); }
  EXPECT_EQ(read_file(directory / "out.csv"), "before");
}

TEST(OutputFile, FollowsALinkInsteadOfReplacingIt) {
  const TemporaryDirectory directory;
  write_file(directory / "real", "before");
  std::filesystem::create_symlink(directory / "real", directory / "link");
  OutputFile file(directory / "link");
  file.write("after");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
  EXPECT_EQ(read_file(directory / "real"), "after");
}

TEST(OutputFile, RefusesADirectoryADeviceAndAMissingDirectory) {
  const TemporaryDirectory directory;
  const auto refuses = [](const std::filesystem::path& target, const std::string& reason) {
    EXPECT_THAT([&] { OutputFile file(target); },
                testing::ThrowsMessage<std::runtime_error>(
                    "\"" + target.string() + "\": cannot be written: " + reason +
                    "; valid is a file in an existing, writable directory"));
  };
  refuses(directory.path(), "not a regular file");
  refuses("/dev/null", "not a regular file");
  refuses(directory / "none/out.csv", "No such file or directory");
  refuses("", "no file name");
  EXPECT_EQ(directory.file_count(), 0);
}

TEST(OutputFile, ReportsAFullDisk) {
  // /dev/full is refused as a target, so the temporary file leads there instead.
  const TemporaryDirectory directory;
  const std::string temporary = "out.csv.partial-" + std::to_string(::getpid());
  std::filesystem::create_symlink("/dev/full", directory / temporary);
  OutputFile file(directory / "out.csv");
  const auto write_and_commit = [&] {
    file.write(std::string(1 << 16, 'x'));
    file.commit();
  };
  EXPECT_THAT(write_and_commit,
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("No space left")));
  EXPECT_FALSE(std::filesystem::exists(directory / "out.csv"));
}

TEST(SameFile, SeesThroughDotsAndLinks) {
  const TemporaryDirectory directory;
  write_file(directory / "real", "");
  std::filesystem::create_symlink(directory / "real", directory / "link");
  std::filesystem::create_hard_link(directory / "real", directory / "hard");
  EXPECT_TRUE(same_file(directory / "new", directory.path() / ".." / directory.path().filename() / "new"));
  EXPECT_TRUE(same_file(directory / "real", directory / "link"));
  EXPECT_TRUE(same_file(directory / "real", directory / "hard"));
  EXPECT_FALSE(same_file(directory / "real", directory / "new"));
  EXPECT_FALSE(same_file(directory / "new", directory / "newer"));
}

}  // namespace
}  // namespace polhode::demos
