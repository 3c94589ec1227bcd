#pragma once

// JumpSources: finds the jumps that an edit of the map may have changed, from behind: which jump points look at the
// cells around the edit?
//
// A jump looks along straight runs up to their first stop, and along diagonal runs at such straight runs to both
// sides. So what looks at a cell is found by going back from it: straight to the last stop before, and from each
// cell on this way diagonally as long as steps are legal.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/jump_graph.hpp"

namespace wend {

class JumpSources {
 public:
  /// `graph` must live as long. `steps`: how many steps from cell to cell all its searches may take together.
  JumpSources(const JumpGraph& graph, std::size_t steps) : graph_(&graph), steps_left_(steps) {}

  /// Finds the jumps from whose jump points a search may go on differently because the map has changed in these
  /// boxes; at least these. False if the steps run out.
  bool find(std::span<const CellBox> boxes);

  /// Finds the jumps from whose jump points a search may go on to this jump; at least these. False if the steps run
  /// out.
  bool find_before(Jump jump);

  /// Each jump once.
  const std::vector<Jump>& jumps() const { return jumps_; }

 private:
  /// Stretches of neighbouring lines of cells that run in one direction, each up to its end in the box.
  struct Stretches {
    Direction ahead;
    CellBox box;
    std::vector<int> lengths;  // by line of the box, from the first

    Cell end(std::size_t line) const;  // the last cell of a line
    bool contains(Cell cell) const;
  };

  void add_all(const CellBox& around);
  void add(Cell cell, Direction towards);
  Stretches stretches(Direction ahead, const CellBox& around) const;
  bool add_before(Direction ahead, const CellBox& around);
  bool go_back(const Stretches& stretches, Direction diagonal);
  bool take_steps(std::size_t steps);
  void remove_repeated();

  const JumpGraph* graph_;
  std::vector<Jump> jumps_;
  std::size_t steps_left_;
};

}  // namespace wend
