#pragma once

// IndexEngine: answers queries from an index that threads share. It owns scratch memory: each thread
// needs its own engine.
//
// An index stores only which cells are passable. Steps go to the 8 neighbours and do not cut corners.

#include <cstdint>
#include <numbers>
#include <span>

#include "wend/geometry/cell.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The length of a path as numbers of steps.
struct OctileSteps {
  std::uint32_t straight = 0;
  std::uint32_t diagonal = 0;

  double cost() const {
    return static_cast<double>(straight) + std::numbers::sqrt2 * static_cast<double>(diagonal);
  }
  /// The number of cells of the path.
  std::size_t cells() const { return std::size_t{straight} + diagonal + 1; }

  friend bool operator==(const OctileSteps&, const OctileSteps&) = default;
};

class IndexEngine {
 public:
  virtual ~IndexEngine() = default;

  /// The length of the cheapest path. Both cells must be passable, different and connected.
  virtual OctileSteps find(Cell start, Cell goal) = 0;

  /// Writes the path of the last find(), including both ends. The buffer must hold cells().
  virtual void write(std::span<Cell> cells) = 0;

  /// The work of the last find().
  virtual SearchMetrics metrics() const = 0;
};

}  // namespace wend
