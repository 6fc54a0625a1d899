#pragma once

#include <functional>
#include <string>
#include <vector>

namespace polhode::demos {

/// The processes that work on one task: those started by mpirun, or this one alone. Two files implement it,
/// ranks_single.cpp and ranks_mpi.cpp; CMake chooses one of them.
class Ranks {
 public:
  Ranks(int& argument_count, char**& arguments);
  ~Ranks();  // NOLINT(performance-trivially-destructible): under MPI it is not
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const;
  int count() const;
  bool is_first() const { return rank() == 0; }

  /// Returns on rank 0 the bytes of every rank, in rank order, and nothing on the other ranks. All ranks must
  /// call it together.
  std::vector<std::string> gather(const std::string& bytes);
  /// Returns rank 0's bytes on every rank.
  std::string broadcast(std::string bytes);

  /// Calls the function on each rank. If it throws on one rank, all ranks throw the same, so that none waits
  /// for another.
  void together(const std::function<void()>& action);
  /// Returns true while all ranks handle an exception from together().
  bool stopped_together() const { return stopped_together_; }

  /// Ends all ranks at once with this exit code. Does nothing if there is only one.
  void end_all(int exit_code);

 private:
  bool stopped_together_ = false;
};

}  // namespace polhode::demos
