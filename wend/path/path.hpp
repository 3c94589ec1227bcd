#pragma once

// Path: the way from a start to a goal, both included, as its planner made it: a list of
// neighbouring cells. Poses, and metres, are made from it on demand.
//
//   for (const wend::Cell cell : plan->path.cells()) ...

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class Path {
 public:
  Path() = default;
  explicit Path(std::vector<Cell> cells) : cells_(std::move(cells)) {}

  bool empty() const { return cells_.empty(); }
  std::size_t size() const { return cells_.size(); }
  std::span<const Cell> cells() const { return cells_; }

  /// Geometric length in cells: straight steps plus sqrt(2) times diagonal ones, counted exactly
  /// (for cells farther apart: the Euclidean distance of their centres).
  double length() const;

  /// The cell centres in grid coordinates, each heading towards the next one (the last as the one
  /// before it; a single cell heads along +x).
  std::vector<Pose> poses() const;

  /// The cell centres in the map's frame, in metres.
  std::vector<Point> points_in_metres(const Frame& frame) const;

  /// For planners that write into a path they are given: memory is kept.
  void clear() { cells_.clear(); }
  void append(Cell cell) { cells_.push_back(cell); }
  void reverse();

  friend bool operator==(const Path&, const Path&) = default;

 private:
  std::vector<Cell> cells_;
};

}  // namespace wend
