// Files that are not what they seem to be.
#include "scenario/input_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <future>
#include <sstream>
#include <thread>

#include "demos/support_files.h"

namespace polhode::demos {
namespace {

using testing::ThrowsMessage;

class InputFile : public testing::Test {
 protected:
  InputFile() { ::mkfifo(pipe_.c_str(), 0600); }

  TemporaryDirectory directory_;
  std::filesystem::path pipe_ = directory_ / "pipe";
};

TEST_F(InputFile, IsReadUpToItsLimit) {
  write_file(directory_ / "file", std::string(100000, 'a') + '\0' + "b");
  EXPECT_EQ(read_text_file(directory_ / "file", 100002), std::string(100000, 'a') + '\0' + "b");
  EXPECT_THAT([&] { read_text_file(directory_ / "file", 100001); },
              ThrowsMessage<InputFileError>("has more than 100001 bytes"));
}

TEST_F(InputFile, ThatIsNeitherARegularFileNorAPipeIsRefused) {
  EXPECT_THAT([&] { read_text_file(directory_ / "none", 10); },
              ThrowsMessage<InputFileError>("no such file"));
  EXPECT_THAT([&] { read_text_file(std::string(5000, 'a'), 10); },
              ThrowsMessage<InputFileError>("cannot be read: File name too long"));
  for (const std::filesystem::path& file :
       {directory_.path(), std::filesystem::path("/dev/zero"), std::filesystem::path("/dev/urandom"),
        std::filesystem::path("/dev/null")}) {
    EXPECT_THAT([&] { read_text_file(file, 10); },
                ThrowsMessage<InputFileError>("neither a regular file nor a pipe"));
    EXPECT_THAT([&] { open_regular_file(file); }, ThrowsMessage<InputFileError>("not a regular file"));
  }
  EXPECT_THAT([&] { open_regular_file(pipe_); }, ThrowsMessage<InputFileError>("not a regular file"));
}

// Its reported size is 0.
TEST_F(InputFile, OfTheKernelIsReadUpToTheLimitToo) {
  const std::string file = "/proc/self/pagemap";
  if (!std::ifstream(file).get()) GTEST_SKIP() << "no " << file;
  EXPECT_THAT([&] { read_text_file(file, 1000000); },
              ThrowsMessage<InputFileError>("has more than 1000000 bytes"));
}

TEST_F(InputFile, MayBeAPipeThatIsWrittenLater) {
  const std::future<void> writer = std::async(std::launch::async, [&] {
    std::ofstream stream(pipe_);  // blocks until there is a reader
    stream << "first " << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stream << "second";
  });
  EXPECT_EQ(read_text_file(pipe_, 100), "first second");
}

TEST_F(InputFile, ThatIsAPipeIsNotWaitedForForEver) {
  const auto expect_no_end = [&] {
    EXPECT_THAT([&] { read_text_file(pipe_, 100, std::chrono::milliseconds(50)); },
                ThrowsMessage<InputFileError>("a pipe that was not closed within 0.05 s"));
  };
  expect_no_end();  // there is no writer
  const int silent = ::open(pipe_.c_str(), O_RDWR);
  expect_no_end();
  EXPECT_EQ(::write(silent, "a", 1), 1);
  expect_no_end();
  ::close(silent);
}

TEST_F(InputFile, IsReadLineByLineUpToTheLimitOfALine) {
  std::istringstream stream(std::string("abc\n\nd\0e\nabcd\nf", 15));
  std::string line;
  EXPECT_TRUE(read_line(stream, 3, line));
  EXPECT_EQ(line, "abc");
  EXPECT_TRUE(read_line(stream, 3, line));
  EXPECT_EQ(line, "");
  EXPECT_TRUE(read_line(stream, 3, line));
  EXPECT_EQ(line, std::string("d\0e", 3));
  EXPECT_FALSE(read_line(stream, 3, line));
  EXPECT_EQ(line, "abc");

  std::istringstream torn("a");
  EXPECT_TRUE(read_line(torn, 3, line));
  EXPECT_EQ(line, "a");
  EXPECT_TRUE(torn.eof());
  EXPECT_FALSE(read_line(torn, 3, line));
  EXPECT_EQ(line, "");
}

}  // namespace
}  // namespace polhode::demos
