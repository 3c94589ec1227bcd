#pragma once

// Ranks: the processes that mpirun started together. MPI is in a module that is loaded when the
// first Ranks is made.

namespace wend::cli {

class Ranks {
 public:
  /// Make only one per program. Throws InputError if wend was built without MPI, or MPI does not start.
  Ranks();

  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }  // of this process, from 0
  int count() const { return count_; }

  /// Returns when all ranks are here. Throws InputError if that is impossible.
  void wait_for_all();

  /// Ends all ranks at once, this one too: for a rank that cannot go on, while the others would wait
  /// for it.
  [[noreturn]] void end_all(int exit_code);

 private:
  void* module_;
  int rank_ = 0;
  int count_ = 1;
};

}  // namespace wend::cli
