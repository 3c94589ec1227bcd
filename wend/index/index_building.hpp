#pragma once

// IndexBuilding: the workers, progress callback, cancel flag and deadline of an index build.
//
// Parts of an index whose constructor takes an IndexBuilding look at the cancel flag and the deadline while they are made.
// Once one says so, they end early and are incomplete: their caller asks cancelled() afterwards and discards them.

#include <atomic>
#include <functional>

#include "wend/base/deadline.hpp"
#include "wend/base/workers.hpp"

namespace wend {

struct IndexBuilding {
  Workers* workers = nullptr;  // not owned; null: one thread
  /// Called with the finished share of the work, from 0 to 1, never decreasing, on the building thread.
  std::function<void(double share)> progress = {};
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop

  /// Not owned; null: none. With more than one worker, its clock is read by all of them.
  const Deadline* deadline = nullptr;
  /// Is the cancel flag set, or has the deadline passed?
  bool cancelled() const {
    return (cancel != nullptr && cancel->load(std::memory_order_relaxed)) ||
           (deadline != nullptr && deadline->passed());
  }
  /// Calls `progress`, if it is set.
  void tell(double share) const {
    if (progress) progress(share);
  }
};

}  // namespace wend
