// On a full disk the file stays as it was, and a message names the file and the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "demos/faults/writers.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

class FullDisk : public WriterTest {
 protected:
  CommandResult with_files_limited_to(std::size_t bytes) const {
    return start([bytes] {
             const rlimit limit = {bytes, bytes};
             ::setrlimit(RLIMIT_FSIZE, &limit);
           })
        .wait();
  }
  void expect_refusal(const CommandResult& result, const std::string& file, const std::string& reason) const {
    expect_refused_in_one_line(result);
    EXPECT_THAT(result.standard_error, HasSubstr("\"" + file + "\": cannot be written: " + reason));
    ASSERT_TRUE(std::filesystem::is_regular_file(target()));
    EXPECT_EQ(read_file(target()), "before");
    EXPECT_EQ(directory_.file_count(), 1 + kept_files());
  }
};

class FullDevice : public FullDisk {};

TEST_P(FullDevice, LeavesTheFileThatWasThere) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  write_file(target(), "before");
  // Makes the temporary file lead to a full device.
  const CommandResult result =
      start([&] {
        std::filesystem::create_symlink("/dev/full",
                                        target().string() + ".partial-" + std::to_string(::getpid()));
      }).wait();
  expect_refusal(result, target().string(), "No space left on device");
}

// A program with a journal opens the temporary file twice.
INSTANTIATE_TEST_SUITE_P(Demos, FullDevice, testing::ValuesIn(writers(false)), name_of);

class LimitedFile : public FullDisk {};

TEST_P(LimitedFile, LeavesTheFileThatWasThere) {
  const std::string whole = clean_text();
  // Messages go to files too.
  ASSERT_GT(whole.size(), 800u);
  write_file(target(), "before");
  expect_refusal(with_files_limited_to(whole.size() * 3 / 4), target().string(), "File too large");
  if (GetParam().has_journal) {
    // The cells are done: only the map remains to be written.
    EXPECT_EQ(kept_files(), 1);
  }
  const CommandResult again = start().wait();
  EXPECT_EQ(again.exit_code, 0) << again.standard_error;
  EXPECT_EQ(directory_.file_count(), 1);
  EXPECT_TRUE(!GetParam().is_reproducible || read_file(target()) == whole);
}

INSTANTIATE_TEST_SUITE_P(Demos, LimitedFile, testing::ValuesIn(writers()), name_of);

class LimitedJournal : public FullDisk {};

TEST_P(LimitedJournal, IsGoneOnWithByALaterRun) {
  const std::string whole = clean_text();
  write_file(target(), "before");
  expect_refusal(with_files_limited_to(600), journal().string(), "File too large");
  EXPECT_EQ(std::filesystem::file_size(journal()), 600u);
  EXPECT_EQ(start().wait().exit_code, 0);
  EXPECT_EQ(read_file(target()), whole);
  EXPECT_EQ(directory_.file_count(), 1);
}

INSTANTIATE_TEST_SUITE_P(Demos, LimitedJournal, testing::ValuesIn(writers(true)), name_of);

}  // namespace
}  // namespace polhode::demos
