#pragma once

// IndexBuilding: with whom an index is built, who is told how far it is, and how it is told to stop.
// IndexError: why there is none.

#include <atomic>
#include <functional>
#include <string>

#include "wend/base/status.hpp"
#include "wend/base/workers.hpp"

namespace wend {

struct IndexBuilding {
  Workers* workers = nullptr;  // not owned; none: one
  /// Told the share that is done, from 0 to 1, never less than before; on the thread that builds.
  std::function<void(double share)> progress;
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  void tell(double share) const {
    if (progress) progress(share);
  }
};

struct IndexError {
  Status status;     // cancelled, unsupported_map, memory_limit, index_mismatch
  std::string what;  // "it was built for another map"
};

}  // namespace wend
