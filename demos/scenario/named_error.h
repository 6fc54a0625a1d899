#pragma once

#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Returns what `work` returns. Prefixes the message of a std::invalid_argument with the scenario's name.
template <typename Work>
auto naming_the_scenario(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
}

}  // namespace polhode::demos
