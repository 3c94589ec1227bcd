#pragma once

// ThreadWorkers: Workers that are threads. The threads live only during a run().

#include "wend/base/compiler.hpp"
#include "wend/base/workers.hpp"

namespace wend {

class WEND_API ThreadWorkers final : public Workers {
 public:
  /// 0: as many threads as the machine runs at once.
  explicit ThreadWorkers(unsigned count = 0);

  /// The number of threads, at least 1. run() works with fewer if the system has no more.
  unsigned count() const override { return count_; }

  /// One worker runs on the calling thread. If `action` throws, no further task begins, and run() throws
  /// the first exception when all workers have ended.
  void run(std::size_t tasks, const Action& action) override;

 private:
  unsigned count_;
};

}  // namespace wend
