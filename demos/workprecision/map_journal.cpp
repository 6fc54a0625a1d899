#include "workprecision/map_journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "scenario/input_file.h"
#include "scenario/json_file.h"
#include "scenario/number_text.h"
#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestHeader = 1 << 16;  // a description has some hundred bytes
constexpr std::size_t kLongestLine = 128;        // two whole numbers and three figures

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw std::runtime_error("\"" + file.string() + "\": " + what);
}

std::string line_of(const CellResult& result, std::size_t figure_count) {
  std::string line = number_text(result.index) + " ";
  for (std::size_t i = 0; i < figure_count; ++i) line += full_number_text(result.figures[i]) + " ";
  return line + number_text(result.diverged_step) + "\n";
}

template <class Number>
bool read_number(const char*& at, const char* end, Number& number, char after) {
  const std::from_chars_result result = std::from_chars(at, end, number);
  if (result.ec != std::errc() || result.ptr == end || *result.ptr != after) return false;
  at = result.ptr + 1;
  return true;
}

// Returns the cell in a line that ends in a newline; nothing if the line is incomplete or of no cell of the
// map.
std::optional<CellResult> cell_in(const std::string& line, const CellMap& map) {
  CellResult result{};
  const char* at = line.data();
  const char* end = at + line.size();
  bool whole = read_number(at, end, result.index, ' ');
  for (std::size_t i = 0; i < map.figure_count(); ++i) {
    whole = whole && read_number(at, end, result.figures[i], ' ') && std::isfinite(result.figures[i]);
  }
  whole = whole && read_number(at, end, result.diverged_step, '\n');
  if (!whole || result.index < 0 || result.index >= map.cell_count()) return std::nullopt;
  return result;
}

// Returns for example "steps is 1000 there and 500 here".
std::string difference(const std::string& there, const std::string& here) {
  constexpr std::size_t kLongestValue = 1000;
  nlohmann::json a;
  try {
    a = parse_json(there, "");
  } catch (const ScenarioError&) {
    // Invalid JSON has no keys to compare.
  }
  if (!a.is_object()) return "it is not the journal of a map";
  std::string text;
  const nlohmann::json b = nlohmann::json::parse(here);
  for (const auto& [key, value] : b.items()) {
    const nlohmann::json other = a.value(key, nlohmann::json());
    if (other == value) continue;
    text += (text.empty() ? "" : "; ") + key + " is " + shortened(other.dump(), kLongestValue) +
            " there and " + value.dump() + " here";
  }
  return text.empty() ? "its first line differs from this map's" : text;
}

std::ifstream opened(const fs::path& file) {
  try {
    return open_regular_file(file);
  } catch (const InputFileError& error) {
    fail(file, error.what());
  }
}

}  // namespace

MapJournal::MapJournal(const fs::path& file, const CellMap& map, bool restart)
    : path_(file), figure_count_(map.figure_count()) {
  open(restart);
  try {
    read(map);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

MapJournal::~MapJournal() {
  ::close(descriptor_);  // also unlocks it
}

void MapJournal::open(bool restart) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    fail(path_, "the journal is not a regular file; choose another output file or remove the journal");
  }
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, std::string("cannot be written: ") + std::strerror(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    ::close(descriptor_);
    fail(path_, "another run is using it; choose another output file or wait for that run");
  }
  if (restart && ::ftruncate(descriptor_, 0) != 0) fail(path_, std::strerror(errno));
}

void MapJournal::read(const CellMap& map) {
  const std::string header = map.description();
  std::ifstream lines = opened(path_);
  std::string line;
  read_line(lines, kLongestHeader, line);
  // The run was killed before its first line was complete: the journal is empty.
  if (lines.eof() && header.compare(0, line.size(), line) == 0) return start_over(header + "\n");
  if (line != header) {
    fail(path_,
         "is of another run: " + difference(line, header) + "; delete it, or start over with --restart");
  }
  std::size_t good = header.size() + 1;
  while (read_line(lines, kLongestLine, line) && !lines.eof()) {
    const std::optional<CellResult> result = cell_in(line + "\n", map);
    if (!result) break;
    if (static_cast<std::int64_t>(finished_.size()) == map.cell_count()) {
      fail(path_, "holds more cells than this map has, " + number_text(map.cell_count()) +
                      "; delete it, or start over with --restart");
    }
    finished_.push_back(*result);
    good += line.size() + 1;
  }
  if (::ftruncate(descriptor_, static_cast<off_t>(good)) != 0) fail(path_, std::strerror(errno));
  ::lseek(descriptor_, 0, SEEK_END);
}

void MapJournal::start_over(const std::string& header) {
  if (::ftruncate(descriptor_, 0) != 0) fail(path_, std::strerror(errno));
  ::lseek(descriptor_, 0, SEEK_SET);
  write(header);
}

void MapJournal::append(const std::vector<CellResult>& results) {
  std::string lines;
  for (const CellResult& result : results) lines += line_of(result, figure_count_);
  write(lines);
}

void MapJournal::write(const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t now = ::write(descriptor_, text.data() + written, text.size() - written);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) fail(path_, std::string("cannot be written: ") + std::strerror(errno));
    written += static_cast<std::size_t>(now);
  }
}

void MapJournal::remove() {
  std::error_code error;
  if (!fs::remove(path_, error) && error) fail(path_, error.message());
}

}  // namespace polhode::demos
