#pragma once

// IndexBuilding: the workers, progress callback and cancel flag of an index build.
//
// Parts of an index whose constructor takes an IndexBuilding look at the cancel flag while they are made. If it is set,
// they end early and are incomplete: their caller asks cancelled() afterwards and discards them.

#include <atomic>
#include <functional>

#include "wend/base/workers.hpp"

namespace wend {

struct IndexBuilding {
  Workers* workers = nullptr;  // not owned; null: one thread
  /// Called with the finished share of the work, from 0 to 1, never decreasing, on the building thread.
  std::function<void(double share)> progress = {};
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop

  /// Is the cancel flag set?
  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  /// Calls `progress`, if it is set.
  void tell(double share) const {
    if (progress) progress(share);
  }
};

}  // namespace wend
