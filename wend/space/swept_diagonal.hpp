#pragma once

// SweptDiagonal: may the robot's disc move along a diagonal step that cuts a corner?
//
// Without cutting corners the disc is safe wherever both ends and both cells beside the step are
// passable. With the corner rules `one` and `both` the way between the ends is swept exactly: no
// closed obstacle square may come nearer than the radius to the segment of centres.

#include <array>
#include <vector>

#include "wend/geometry/direction.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

class SweptDiagonal {
 public:
  /// `cuts_corners`: can there be such steps at all?
  SweptDiagonal(const FreeSpace& space, bool cuts_corners);

  /// Is there anything to sweep? Not for a point, and not where no corner is cut.
  bool needed() const { return needed_; }

  /// Is the diagonal step from `from` free, given that both ends are passable? O(radius).
  bool free(Cell from, Direction diagonal) const;

 private:
  FreeSpace space_;
  bool needed_;
  // By direction: squares, relative to the first cell, too near to the way but not to its ends.
  std::array<std::vector<Cell>, kDirections> threatening_;
};

}  // namespace wend
