#pragma once

// BoostAStar: Boost.Graph's astar_search as its users write it, the baseline of our benchmark.
//
// The grid is a compressed sparse row graph with one vertex a cell and no corner cutting, the
// heuristic is octile, the search ends at the goal. Boost initialises every vertex at every query.

#include <cstdint>
#include <memory>

#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

class BoostAStar {
 public:
  explicit BoostAStar(const FreeSpace& space);
  ~BoostAStar();
  BoostAStar(const BoostAStar&) = delete;
  BoostAStar& operator=(const BoostAStar&) = delete;
  BoostAStar(BoostAStar&&) noexcept;
  BoostAStar& operator=(BoostAStar&&) noexcept;

  struct Answer {
    Status status;  // found, unreachable or the limit that was reached
    double cost;    // infinite without a path
    std::uint64_t expanded;
  };

  /// Writes the path, if there is one.
  Answer plan(Cell start, Cell goal, Path& path, const Limits& limits = {});

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

}  // namespace wend::bench
