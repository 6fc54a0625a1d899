#include "scenario/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <istream>

#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

[[noreturn]] void fail_to_read() {
  throw InputFileError(std::string("cannot be read: ") + std::strerror(errno));
}

fs::file_type type_of(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputFileError("no such file");
  if (error) throw InputFileError("cannot be read: " + error.message());
  return status.type();
}

class Descriptor {
 public:
  // Without O_NONBLOCK, opening a pipe without a writer would block.
  explicit Descriptor(const fs::path& file)
      : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
    if (number_ < 0) fail_to_read();
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  /// Returns false if there is nothing to read by then.
  bool wait_until(Clock::time_point deadline) const {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd readable{number_, POLLIN, 0};
    const int count =
        ::poll(&readable, 1, static_cast<int>(std::max(left.count(), decltype(left.count()){0})));
    if (count < 0) fail_to_read();
    return count > 0;
  }

  /// Returns the number of bytes read, 0 at the end.
  std::size_t read(char* begin, std::size_t size) const {
    const ssize_t count = ::read(number_, begin, size);
    if (count < 0) fail_to_read();
    return static_cast<std::size_t>(count);
  }

 private:
  int number_;
};

}  // namespace

std::string read_text_file(const fs::path& file, std::size_t most, std::chrono::milliseconds patience) {
  const fs::file_type type = type_of(file);
  // Devices are not opened, since opening some of them has an effect.
  if (type != fs::file_type::regular && type != fs::file_type::fifo) {
    throw InputFileError("neither a regular file nor a pipe");
  }
  const Descriptor descriptor(file);
  const Clock::time_point deadline = Clock::now() + patience;
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    if (!descriptor.wait_until(deadline)) {
      throw InputFileError("a pipe that was not closed within " +
                           number_text(std::chrono::duration<double>(patience).count()) + " s");
    }
    const std::size_t size = descriptor.read(buffer.data(), buffer.size());
    if (size == 0) return text;
    text.append(buffer.data(), size);
    // Counted here, since a file's reported size may be wrong.
    if (text.size() > most) {
      throw InputFileError("has more than " + number_text(static_cast<std::int64_t>(most)) + " bytes");
    }
  }
}

std::ifstream open_regular_file(const fs::path& file) {
  if (type_of(file) != fs::file_type::regular) throw InputFileError("not a regular file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail_to_read();
  return stream;
}

bool read_line(std::istream& stream, std::size_t longest, std::string& line) {
  line.resize(longest + 1);  // includes the final 0
  stream.getline(line.data(), static_cast<std::streamsize>(line.size()));
  const bool is_read = !stream.fail();
  const bool has_newline = is_read && !stream.eof();
  line.resize(static_cast<std::size_t>(stream.gcount()) - (has_newline ? 1 : 0));
  return is_read;
}

}  // namespace polhode::demos
