#pragma once

// IndexEngine: answers queries from an index that threads share, with scratch memory of its own.
// One engine a thread.
//
// An index knows the passable cells alone. Steps go to the 8 neighbours and cut no corner.

#include <cstdint>
#include <numbers>
#include <span>

#include "wend/geometry/cell.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The length of a path by its steps.
struct OctileSteps {
  std::uint32_t straight = 0;
  std::uint32_t diagonal = 0;

  double cost() const {
    return static_cast<double>(straight) + std::numbers::sqrt2 * static_cast<double>(diagonal);
  }
  /// How many cells such a path has.
  std::size_t cells() const { return std::size_t{straight} + diagonal + 1; }

  friend bool operator==(const OctileSteps&, const OctileSteps&) = default;
};

class IndexEngine {
 public:
  virtual ~IndexEngine() = default;

  /// The length of the cheapest path. Both cells are passable, different and connected.
  virtual OctileSteps find(Cell start, Cell goal) = 0;

  /// Writes the path of the pair found last, its ends included; there is room for cells().
  virtual void write(std::span<Cell> cells) = 0;

  /// The work of the last find().
  virtual SearchMetrics metrics() const = 0;
};

}  // namespace wend
