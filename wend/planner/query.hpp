#pragma once

// Query: from where, to where, with what limits, and who watches.

#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class SearchObserver;

/// Poses are in grid coordinates; a grid planner takes the cell that a pose lies in. With several
/// goals the cheapest one is found.
struct Query {
  Pose start;
  std::vector<Pose> goals;
  Limits limits = {};
  SearchObserver* observer = nullptr;  // told every event of the search; not owned

  static Query between(Cell start, Cell goal) { return {pose_at(start), {pose_at(goal)}}; }
};

}  // namespace wend
