#include "scenario/scenario_directory.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "scenario/build_info.h"
#include "scenario/scenario_reader.h"

namespace polhode::demos {

namespace {

namespace fs = std::filesystem;

bool is_file_name(const std::string& text) {
  return text.find('/') != std::string::npos || fs::path(text).extension() == ".json";
}

fs::path chosen_directory() {
  const char* chosen = std::getenv("POLHODE_SCENARIOS");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path() / kScenariosFromExecutable;
}

}  // namespace

fs::path scenario_directory() {
  const fs::path directory = chosen_directory().lexically_normal();
  std::error_code error;
  if (!fs::is_directory(directory, error)) {
    throw ScenarioError(directory.string() +
                        ": no such directory; set POLHODE_SCENARIOS to the one with the scenario files");
  }
  return directory;
}

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(scenario_directory())) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scenario find_scenario(const std::string& name_or_file) {
  if (is_file_name(name_or_file)) return read_scenario(name_or_file);
  const std::vector<std::string> names = scenario_names();
  if (std::binary_search(names.begin(), names.end(), name_or_file)) {
    return read_scenario(scenario_directory() / (name_or_file + ".json"));
  }
  std::string valid;
  for (const std::string& name : names) valid += name + ", ";
  throw ScenarioError("unknown scenario \"" + name_or_file + "\"; valid are " + valid +
                      "or a path to a .json file");
}

}  // namespace polhode::demos
