#pragma once

// KeptField: the last field of costs of a session. It is made outside of all locks that an edit or a plan takes.

#include <cstdint>
#include <memory>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/mutex.hpp"

namespace wend {

/// All threads may call everything.
class KeptField {
 public:
  struct Answer {
    std::shared_ptr<const CostToGo> costs;  // never null
    SearchMetrics metrics = {};             // of making it; 0 if it was kept
  };

  /// The field to these goals on a space, which is known by its version. Who asks for the field that another thread
  /// makes waits for it. Fails as CostToGo::make() does.
  Expected<Answer, PlanFailure> get(const FreeSpace& space, std::uint64_t version,
                                    std::vector<Cell> goals, GridMoves moves, const Limits& limits);

  /// Never waits: a field that is being made is for those who asked for it.
  void forget();

 private:
  /// A field, made or not. The first that has the lock makes it.
  struct Slot {
    std::uint64_t version;
    std::vector<Cell> goals;
    GridMoves moves;
    Mutex mutex = {};  // guards the field
    std::shared_ptr<const CostToGo> costs = {};
  };

  std::shared_ptr<Slot> slot_for(std::uint64_t version, std::vector<Cell> goals, GridMoves moves);

  Mutex mutex_;  // guards the pointer
  std::shared_ptr<Slot> slot_;
};

}  // namespace wend
