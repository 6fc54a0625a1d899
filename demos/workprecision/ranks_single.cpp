// Implements Ranks for a program without MPI: a single process.
#include "workprecision/ranks.h"

namespace polhode::demos {

Ranks::Ranks(int& /*argument_count*/, char**& /*arguments*/) {}

Ranks::~Ranks() = default;

int Ranks::rank() const {
  return 0;
}

int Ranks::count() const {
  return 1;
}

std::vector<std::string> Ranks::gather(const std::string& bytes) {
  return {bytes};
}

std::string Ranks::broadcast(std::string bytes) {
  return bytes;
}

void Ranks::end_all(int /*exit_code*/) {}

}  // namespace polhode::demos
