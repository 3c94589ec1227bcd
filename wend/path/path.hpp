#pragma once

// Path: the path from a start to a goal, both included: one list, of neighbouring cells, of waypoints,
// or of a car's poses; cells that are not neighbours if its planner turns at any angle. Arcs, segments
// and points in metres are computed from it on demand.
//
//   for (const wend::Cell cell : plan->path.cells()) cells.push_back(cell);
//
// An arc joins two poses of a car: it leaves the first one along its heading and ends in the second
// (a line if the heading stays), in reverse if the second lies behind. Where no such arc ends with the
// second heading, the robot turns in place or moves sideways: a segment joins them. Lines join cells,
// from centre to centre, and the waypoints of a simplified or smoothed path.
//
//   const wend::Path path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
//   for (const wend::Arc& arc : path.arcs()) length += arc.length;
//
// Code that has to tell the three kinds apart calls visit() and says for each of them what to do:
//
//   const std::size_t lines = path.visit(
//       [](std::span<const wend::Cell> cells) { return cells.size() - 1; },
//       [](std::span<const wend::Point> waypoints) { return waypoints.size() - 1; },
//       [](const wend::JoinedPoses& poses) { return poses.segment_count(); });

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {

/// A reusable list of cells that keeps its memory: resizing it costs nothing if it had as many
/// cells before.
class CellBuffer {
 public:
  /// Empty.
  CellBuffer() = default;
  /// Takes over the cells and their memory.
  explicit CellBuffer(std::vector<Cell> cells) : memory_(std::move(cells)), size_(memory_.size()) {}

  /// The number of cells.
  std::size_t size() const { return size_; }
  /// Are there no cells?
  bool empty() const { return size_ == 0; }
  /// The cells. Valid until the buffer grows.
  std::span<const Cell> cells() const { return {memory_.data(), size_}; }
  /// The same for writing.
  std::span<Cell> cells() { return {memory_.data(), size_}; }

  /// Removes all cells and keeps the memory.
  void clear() { size_ = 0; }
  /// Adds a cell at the end. O(1) amortised.
  void append(Cell cell) {
    if (size_ == memory_.size()) {
      memory_.push_back(cell);
    } else {
      memory_[size_] = cell;
    }
    ++size_;
  }

  /// Resizes to `size` cells with unspecified values.
  void resize_unset(std::size_t size) {
    if (size > memory_.size()) memory_.resize(size);
    size_ = size;
  }

  /// Compares the cells.
  friend bool operator==(const CellBuffer& a, const CellBuffer& b) {
    return std::ranges::equal(a.cells(), b.cells());
  }

 private:
  std::vector<Cell> memory_;  // as large as it ever was
  std::size_t size_ = 0;
};

/// The poses of a car's path, and the segments that join them. A view: the path must outlive it.
class WEND_API JoinedPoses {
 public:
  /// A view of poses in grid coordinates.
  explicit JoinedPoses(std::span<const Pose> poses) : poses_(poses) {}

  /// The poses, in grid coordinates.
  std::span<const Pose> poses() const { return poses_; }
  /// One fewer than poses; 0 without poses.
  std::size_t segment_count() const { return poses_.empty() ? 0 : poses_.size() - 1; }

  /// From pose i to pose i + 1: the arc that a car drives, if it ends with the heading of pose i + 1;
  /// else the turn in place or the move to the side. O(1).
  Segment segment(std::size_t i) const;

  /// The way of the base point along that segment; of length 0 for a turn in place. O(1).
  Arc arc(std::size_t i) const;

 private:
  std::span<const Pose> poses_;
};

class WEND_API Path {
 public:
  /// An empty path.
  Path() = default;
  /// A path of cells.
  explicit Path(std::vector<Cell> cells) : joints_(CellBuffer(std::move(cells))) {}

  /// A path of poses, in grid coordinates.
  static Path through(std::vector<Pose> poses);

  /// A path of waypoints, in grid coordinates.
  static Path along(std::vector<Point> waypoints);

  /// A path of waypoints that leads over cells: each waypoint is the centre of its cell, but for the first and the last
  /// one, which may lie anywhere in theirs. Otherwise a path of waypoints like any other.
  static Path over_cells(std::vector<Point> waypoints);

  /// Is there no cell, pose or waypoint?
  bool empty() const { return size() == 0; }
  /// The number of cells, poses or waypoints.
  std::size_t size() const {
    return std::max({cells().size(), waypoints().size(), driven_poses().size()});
  }

  /// Is it made of poses, not of cells or waypoints? An empty path is not.
  bool driven() const { return !driven_poses().empty(); }

  /// Is it made of cells, or of waypoints in cells, see over_cells()?
  bool leads_over_cells() const { return over_cells_ || !cells().empty(); }

  /// The cells of such a path, one after the other; of others, those in which its points lie. O(n).
  std::vector<Cell> passed_cells() const;

  /// Is it made of cells, each a neighbour of the one before? O(n).
  bool of_steps() const;

  /// Calls the visitor for what the path is made of: one takes std::span<const Cell>, one
  /// std::span<const Point> (the waypoints), one JoinedPoses. An empty path has no cells.
  template <class... Visitors>
  decltype(auto) visit(Visitors&&... visitors) const {
    struct Overloads : std::remove_cvref_t<Visitors>... {
      using std::remove_cvref_t<Visitors>::operator()...;
    };
    const Overloads visitor{std::forward<Visitors>(visitors)...};
    if (!waypoints().empty()) return visitor(waypoints());
    if (driven()) return visitor(JoinedPoses(driven_poses()));
    return visitor(cells());
  }

  /// The cells of a path of cells; else empty.
  std::span<const Cell> cells() const {
    const auto* cells = std::get_if<CellBuffer>(&joints_);
    return cells != nullptr ? cells->cells() : std::span<const Cell>();
  }

  /// The poses of a car's path, in grid coordinates; else empty.
  std::span<const Pose> driven_poses() const { return joints_of<Pose>(); }

  /// The waypoints of a path of waypoints, in grid coordinates; else empty.
  std::span<const Point> waypoints() const { return joints_of<Point>(); }

  /// The start, the joints and the end, in grid coordinates: the centres of cells, the points of
  /// poses, the waypoints.
  std::vector<Point> points() const;

  /// The length in cells. For cells: straight steps plus sqrt(2) times diagonal ones, counted
  /// exactly (for cells farther apart, the Euclidean distance of their centres). For waypoints: the
  /// sum of their distances. For poses: the lengths of the arcs, also in reverse.
  double length() const;

  /// The poses, in grid coordinates. For cells and waypoints: their points, each heading towards
  /// the next one (the last like the one before it; a single one along +x).
  std::vector<Pose> poses() const;

  /// The ways of the base point between these poses, one fewer than poses: lines, arcs; of length 0
  /// for a turn in place. Empty for an empty path. The heading of an arc is the direction of travel.
  std::vector<Arc> arcs() const;

  /// The same with the headings of the robot.
  std::vector<Segment> segments() const;

  /// Its points in the map's frame, in metres.
  std::vector<MapPoint> points_in_metres(const Frame& frame) const;

  /// Makes the path empty and keeps its memory, for planners that write into an existing path.
  void clear();
  /// Adds a cell at the end. The path is empty or made of cells. O(1) amortised.
  void append(Cell cell) { made_of<CellBuffer>().append(cell); }
  /// Replaces the cells by `count` cells for the caller to write. The path is empty or made of cells.
  std::span<Cell> make_cells(std::size_t count) {
    auto& cells = made_of<CellBuffer>();
    cells.resize_unset(count);
    return cells.cells();
  }
  /// Adds a pose, in grid coordinates. The path is empty or made of poses. O(1) amortised.
  void drive_to(const Pose& pose) { made_of<std::vector<Pose>>().push_back(pose); }
  /// Adds a waypoint, in grid coordinates. The path is empty or made of waypoints. O(1) amortised.
  void go_to(Point waypoint) { made_of<std::vector<Point>>().push_back(waypoint); }
  /// Reverses the order of the cells, poses or waypoints; headings stay. O(n).
  void reverse();

  /// Compares the lists; all empty paths are equal.
  friend bool operator==(const Path& a, const Path& b) {
    return a.joints_ == b.joints_ || (a.empty() && b.empty());
  }

 private:
  template <class Joint>
  std::span<const Joint> joints_of() const {
    const auto* joints = std::get_if<std::vector<Joint>>(&joints_);
    return joints != nullptr ? std::span<const Joint>(*joints) : std::span<const Joint>();
  }

  /// The list to write to. It keeps its memory if the path was of that kind before.
  template <class Joints>
  Joints& made_of() {
    if (auto* const joints = std::get_if<Joints>(&joints_)) return *joints;
    assert(empty());
    return joints_.emplace<Joints>();
  }

  // Poses and not the segments between them: a pose stays exactly where its planner put it, and a
  // search writes its path backwards.
  std::variant<CellBuffer, std::vector<Point>, std::vector<Pose>> joints_;
  bool over_cells_ = false;  // of waypoints
};

}  // namespace wend
