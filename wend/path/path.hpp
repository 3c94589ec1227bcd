#pragma once

// Path: the way from a start to a goal, both included, as its maker left it: a list of neighbouring
// cells, the poses of a car, or waypoints. Poses, and metres, are made from it on demand.
//
//   for (const wend::Cell cell : plan->path.cells()) cells.push_back(cell);
//
// Two poses of a car are joined by the arc that leaves the first one along its heading and ends in
// the second (a line where the heading stays); in reverse, if the second lies behind. Cells are
// joined by lines from centre to centre, and waypoints, which a simplified or smoothed path has, by
// lines too.
//
//   const wend::Path path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
//   for (const wend::Arc& arc : path.arcs()) length += arc.length;

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A list of cells that is written anew again and again, and pays for its memory once: making room for
/// cells that are to be written costs nothing where there were as many before.
class CellBuffer {
 public:
  CellBuffer() = default;
  explicit CellBuffer(std::vector<Cell> cells) : memory_(std::move(cells)), size_(memory_.size()) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::span<const Cell> cells() const { return {memory_.data(), size_}; }
  std::span<Cell> cells() { return {memory_.data(), size_}; }

  void clear() { size_ = 0; }
  void append(Cell cell) {
    if (size_ == memory_.size()) {
      memory_.push_back(cell);
    } else {
      memory_[size_] = cell;
    }
    ++size_;
  }

  /// So many cells, whatever stood there before.
  void resize_unset(std::size_t size) {
    if (size > memory_.size()) memory_.resize(size);
    size_ = size;
  }

  friend bool operator==(const CellBuffer& a, const CellBuffer& b) {
    return std::ranges::equal(a.cells(), b.cells());
  }

 private:
  std::vector<Cell> memory_;  // as large as it ever was
  std::size_t size_ = 0;
};

class Path {
 public:
  Path() = default;
  explicit Path(std::vector<Cell> cells) : cells_(std::move(cells)) {}

  /// A path of poses, in grid coordinates.
  static Path through(std::vector<Pose> poses);

  /// A path of waypoints, in grid coordinates.
  static Path along(std::vector<Point> waypoints);

  bool empty() const { return size() == 0; }
  std::size_t size() const { return cells_.size() + poses_.size() + waypoints_.size(); }

  /// Is it made of poses, not of cells or waypoints?
  bool driven() const { return !poses_.empty(); }

  /// Of a path of cells; else empty.
  std::span<const Cell> cells() const { return cells_.cells(); }

  /// Of a driven path, in grid coordinates; else empty.
  std::span<const Pose> driven_poses() const { return poses_; }

  /// Of a path of waypoints, in grid coordinates; else empty.
  std::span<const Point> waypoints() const { return waypoints_; }

  /// Where it begins, where its pieces meet and where it ends, in grid coordinates: the centres of
  /// cells, the points of poses, the waypoints.
  std::vector<Point> points() const;

  /// In cells. Of cells: straight steps plus sqrt(2) times diagonal ones, counted exactly (for
  /// cells farther apart: the Euclidean distance of their centres). Of waypoints: their distances.
  /// Of poses: the lengths of the arcs, in reverse too.
  double length() const;

  /// In grid coordinates. Of cells and waypoints: their points, each heading towards the next one
  /// (the last as the one before it; a single one heads along +x).
  std::vector<Pose> poses() const;

  /// What joins these poses, one fewer than poses: lines, or a car's arcs. Empty of an empty path.
  std::vector<Arc> arcs() const;

  /// Its points in the map's frame, in metres.
  std::vector<Point> points_in_metres(const Frame& frame) const;

  /// For planners that write into a path they are given: memory is kept. A path has either cells or
  /// poses or waypoints.
  void clear();
  void append(Cell cell) { cells_.append(cell); }
  /// So many cells, in place of all that there were, to be written.
  std::span<Cell> make_cells(std::size_t count) {
    cells_.resize_unset(count);
    return cells_.cells();
  }
  void drive_to(const Pose& pose) { poses_.push_back(pose); }
  void reverse();

  friend bool operator==(const Path&, const Path&) = default;

 private:
  CellBuffer cells_;
  std::vector<Pose> poses_;
  std::vector<Point> waypoints_;
};

}  // namespace wend
