#include "viewer/model/recording.h"

#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "record/output_file.h"
#include "scenario/build_info.h"
#include "scenario/input_file.h"
#include "scenario/json_file.h"
#include "scenario/number_text.h"
#include "scenario/scenario_reader.h"
#include "scenario/scenario_writer.h"
#include "world/body_shape.h"

namespace polhode::demos {

namespace {

/// Fits the largest scenario file with all its defaults written out.
constexpr std::size_t kLongestHeader = 8 << 20;
constexpr std::size_t kDigestWidth = 17;  // includes the separator

constexpr char kFormat[] = "polhode recording 1";

std::string header_line(const Simulation& simulation) {
  nlohmann::ordered_json header;
  header["format"] = kFormat;
  header["polhode_version"] = kVersion;
  header["contenders"] = nlohmann::ordered_json::array();
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    header["contenders"].push_back(simulation.run(index).contender().name);
  }
  header["scenario"] = scenario_json(simulation.scenario());
  return header.dump() + "\n";
}

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016" PRIx64, number);
  return text;
}

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw std::invalid_argument(file + ": " + what + "; valid is a file that polhode_viewer --record wrote");
}

std::ifstream opened(const std::filesystem::path& file) {
  try {
    return open_regular_file(file);
  } catch (const InputFileError& error) {
    refuse(file.string(), error.what());
  }
}

Recording recording_of(const std::string& line, const std::string& file) {
  const nlohmann::json header = parse_json(line, file);
  if (!header.is_object() || header.value("format", nlohmann::json()) != kFormat) {
    refuse(file, std::string("does not begin with a \"format\" of \"") + kFormat + "\"");
  }
  if (!header.contains("scenario") || !header.contains("contenders")) refuse(file, "its header lacks keys");
  std::vector<std::string> names;
  for (const nlohmann::json& name : header["contenders"]) {
    if (!name.is_string()) refuse(file, "a contender in its header is not text");
    names.push_back(name);
  }
  if (names.empty()) refuse(file, "its header has no contenders");
  return {resolved(parse_scenario(header["scenario"].dump(), file)), find_contenders(names), {}};
}

/// Returns the numbers, separated by blanks; none if the text has anything else.
std::vector<std::uint64_t> digests_of(const std::string& line) {
  std::vector<std::uint64_t> digests;
  const char* at = line.data();
  const char* end = at + line.size();
  while (at < end) {
    const std::from_chars_result result = std::from_chars(at, end, digests.emplace_back(), 16);
    if (result.ec != std::errc() || (result.ptr < end && *result.ptr != ' ')) return {};
    at = result.ptr + 1;
  }
  return digests;
}

}  // namespace

void write_recording(const Simulation& simulation, const std::filesystem::path& file) {
  if (simulation.shown_step() > kMostDigests) {
    throw std::runtime_error(file.string() + ": the run is longer than the " + number_text(kMostDigests) +
                             " steps that can be recorded");
  }
  OutputFile output(file);
  output.write(header_line(simulation));
  for (std::int64_t step = 0; step <= simulation.shown_step(); ++step) {
    std::string line;
    for (std::size_t index = 0; index < simulation.size(); ++index) {
      line += (index == 0 ? "" : " ") + hexadecimal(simulation.run(index).digest_at(step));
    }
    output.write(line + "\n");
  }
  output.commit();
}

Recording read_recording(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream lines = opened(file);
  std::string line;
  if (!read_line(lines, kLongestHeader, line) && !line.empty()) {
    refuse(name, "its first line has more than " + std::to_string(kLongestHeader) + " bytes");
  }
  Recording recording = recording_of(line, name);
  const std::size_t contenders = recording.contenders.size();
  const auto refuse_line = [&] {
    refuse(name, "its line of step " + number_text(recording.steps()) + " is not one number per contender");
  };
  while (read_line(lines, kDigestWidth * contenders - 1, line)) {
    recording.digests.push_back(digests_of(line));
    if (recording.digests.back().size() != contenders) refuse_line();
    if (recording.steps() > kMostDigests) {
      refuse(name, "it has more than " + number_text(kMostDigests) + " steps");
    }
  }
  if (!line.empty()) {  // the line is too long
    recording.digests.emplace_back();
    refuse_line();
  }
  if (recording.digests.empty()) refuse(name, "it has no steps");
  return recording;
}

void check_shown_step(const Recording& recording, const Simulation& simulation) {
  const std::int64_t step = simulation.shown_step();
  if (step > recording.steps()) return;
  const std::vector<std::uint64_t>& recorded = recording.digests[static_cast<std::size_t>(step)];
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    if (simulation.run(index).digest_at(step) == recorded.at(index)) continue;
    throw std::runtime_error("the replay differs from the recording in step " + number_text(step) + " of " +
                             simulation.run(index).contender().name + " (t = " +
                             short_number_text(simulation.shown_t_s(), 6) + " s): its bits are others");
  }
}

}  // namespace polhode::demos
