#pragma once

#include <functional>
#include <string>
#include <vector>

namespace polhode::demos {

/// The processes that work on one task: those that mpirun started, or this one alone. Two files implement it,
/// ranks_single.cpp and ranks_mpi.cpp; CMake takes one of them.
class Ranks {
 public:
  Ranks(int& argument_count, char**& arguments);
  ~Ranks();  // NOLINT(performance-trivially-destructible): under MPI it is not
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const;
  int count() const;
  bool is_first() const { return rank() == 0; }

  /// Returns on rank 0 the bytes of every rank, in their order; elsewhere nothing. All ranks must call it
  /// together.
  std::vector<std::string> gather(const std::string& bytes);
  /// Rank 0's bytes, on every rank.
  std::string broadcast(std::string bytes);

  /// Does this on each rank. If it throws on one rank, all ranks throw the same, so that none is left waiting
  /// for another.
  void together(const std::function<void()>& action);
  /// An exception from together() is under way on all ranks.
  bool stopped_together() const { return stopped_together_; }

  /// Ends all ranks with that exit code, at once; does nothing where there is one only.
  void end_all(int exit_code);

 private:
  bool stopped_together_ = false;
};

}  // namespace polhode::demos
