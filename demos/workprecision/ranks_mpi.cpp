// Implements Ranks for the processes started by mpirun. An error inside MPI ends all of them, which is MPI's
// default.
#include <mpi.h>

#include <numeric>
#include <stdexcept>

#include "workprecision/ranks.h"

namespace polhode::demos {

namespace {

// MPI counts with int.
int checked_size(std::size_t size) {
  if (size > 0x7fffffff) throw std::length_error("more than 2 GiB in one message");
  return static_cast<int>(size);
}

}  // namespace

Ranks::Ranks(int& argument_count, char**& arguments) {
  // The computing threads do not call MPI.
  int provided = MPI_THREAD_SINGLE;
  MPI_Init_thread(&argument_count, &arguments, MPI_THREAD_FUNNELED, &provided);
}

Ranks::~Ranks() {
  MPI_Finalize();
}

int Ranks::rank() const {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int Ranks::count() const {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

std::vector<std::string> Ranks::gather(const std::string& bytes) {
  const int size = checked_size(bytes.size());
  std::vector<int> sizes(static_cast<std::size_t>(count()));
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::string all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), '\0');
  checked_size(all.size());
  std::vector<int> starts(sizes.size());
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  MPI_Gatherv(bytes.data(), size, MPI_CHAR, all.data(), sizes.data(), starts.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  std::vector<std::string> parts;
  for (std::size_t i = 0; is_first() && i < sizes.size(); ++i) {
    parts.push_back(all.substr(static_cast<std::size_t>(starts[i]), static_cast<std::size_t>(sizes[i])));
  }
  return parts;
}

std::string Ranks::broadcast(std::string bytes) {
  int size = checked_size(bytes.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  bytes.resize(static_cast<std::size_t>(size));
  MPI_Bcast(bytes.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
  return bytes;
}

void Ranks::end_all(int exit_code) {
  if (count() > 1) MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace polhode::demos
