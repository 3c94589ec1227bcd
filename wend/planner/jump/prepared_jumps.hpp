#pragma once

// PreparedJumps: the jump points and dead ends of a space, found when a planner first asks for them, and shared
// by all planners on this space.
//
// Threads may use it at the same time: one of them prepares, and the others wait.

#include <memory>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/jump/dead_ends.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class PreparedJumps {
 public:
  struct Parts {
    std::shared_ptr<const JumpGraph> graph;
    std::shared_ptr<const DeadEnds> dead_ends;
  };

  explicit PreparedJumps(FreeSpace space) : space_(std::move(space)) {}

  const FreeSpace& space() const { return space_; }

  /// O(cells) the first time.
  Parts parts() {
    const MutexLock lock(mutex_);
    if (parts_.graph == nullptr) {
      const auto boards = std::make_shared<const JumpBoards>(space_.passable());
      parts_.dead_ends = std::make_shared<const DeadEnds>(*boards);
      parts_.graph = std::make_shared<const JumpGraph>(boards);
    }
    return parts_;
  }

 private:
  FreeSpace space_;
  Mutex mutex_;  // guards the rest
  Parts parts_;
};

}  // namespace wend
