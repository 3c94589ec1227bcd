#pragma once

// LegPath: a path as it turns. Between two of its points it goes diagonally first, then straight.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/index/index_engine.hpp"

namespace wend {

class LegPath {
 public:
  void begin(Cell start) {
    points_.assign(1, start);
    steps_ = {};
  }
  void append(Cell point);

  OctileSteps steps() const { return steps_; }

  /// Writes its cells, steps().cells() of them.
  void write(std::span<Cell> cells) const;

 private:
  std::vector<Cell> points_;
  OctileSteps steps_;
};

}  // namespace wend
