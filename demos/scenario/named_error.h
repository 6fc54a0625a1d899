#pragma once

#include <stdexcept>
#include <string>

namespace polhode::demos {

/// Returns what `work` returns. Puts the scenario's name before the message of an invalid argument.
template <typename Work>
auto naming_the_scenario(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
}

}  // namespace polhode::demos
