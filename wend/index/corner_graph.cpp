#include "wend/index/corner_graph.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "wend/geometry/direction.hpp"
#include "wend/jump/bit_lines.hpp"

namespace wend {
namespace {

/// Finds the neighbours of one corner after the other.
class EdgeScan {
 public:
  explicit EdgeScan(const Corners& corners)
      : corners_(corners),
        rows_(with_blocked(BitLines(corners.bits()), BitLines(corners.passable()))),
        columns_(with_blocked(BitLines(corners.bits()).transposed(),
                              BitLines(corners.passable()).transposed())) {}

  void append_neighbours(Cell from, std::vector<CornerEdge>& edges) {
    from_ = from;
    edges_ = &edges;
    for (const Direction straight : kStraightDirections) scan_ray(from, straight, kUnbounded);
    for (const Direction diagonal : kDiagonalDirections) scan_quadrant(diagonal);
  }

 private:
  static constexpr int kUnbounded = std::numeric_limits<int>::max();

  /// Finds the corners between a diagonal and the two straight directions beside it. The stop of a ray
  /// hides what lies farther out on the rays of later cells of the diagonal.
  void scan_quadrant(Direction diagonal) {
    const std::array<Direction, 2> straight = beside(diagonal);
    std::array<int, 2> reach{clear_steps(straight[0]), clear_steps(straight[1])};
    walk_diagonal(corners_.passable(), from_, diagonal, [&](Cell cell) {
      if (append_if_corner(cell)) return false;
      for (std::size_t i = 0; i < straight.size(); ++i) {
        reach[i] = std::min(reach[i], scan_ray(cell, straight[i], reach[i]));
      }
      return true;
    });
  }

  int clear_steps(Direction straight) const { return steps_to_stop(from_, straight) - 1; }

  /// The number of steps to the next cell in a straight direction that is a corner or blocked; it may
  /// lie outside the map.
  int steps_to_stop(Cell from, Direction straight) const {
    const bool along_x = straight == Direction::plus_x || straight == Direction::minus_x;
    const BitLines& stops = along_x ? rows_ : columns_;
    const auto [line, at] = along_x ? std::pair(from.y, from.x) : std::pair(from.x, from.y);
    const bool onward = straight == Direction::plus_x || straight == Direction::plus_y;
    return onward ? stops.distance_ahead(line, at) : stops.distance_back(line, at);
  }

  /// Appends the corner where a ray stops, if it stops within `reach` steps. Returns the number of clear
  /// steps.
  int scan_ray(Cell cell, Direction straight, int reach) {
    const int steps = steps_to_stop(cell, straight);
    if (steps <= reach) append_if_corner(step(cell, straight, steps));
    return steps - 1;
  }

  bool append_if_corner(Cell cell) {
    const std::uint32_t corner = corners_.number(cell);
    if (corner == Corners::kNone) return false;
    edges_->push_back({corner, octile_cost<CornerCost>(from_, cell)});
    return true;
  }

  const Corners& corners_;
  BitLines rows_;  // of the cells that a ray stops at
  BitLines columns_;
  Cell from_;
  std::vector<CornerEdge>* edges_ = nullptr;
};

}  // namespace

CornerGraph::CornerGraph(Corners corners, const IndexBuilding& building)
    : corners_(std::move(corners)), begins_{0} {
  begins_.reserve(size() + 1);
  EdgeScan scan(corners_);
  for (std::uint32_t corner = 0; corner < size(); ++corner) {
    if (building.cancelled()) return;
    scan.append_neighbours(corners_.cell(corner), edges_);
    begins_.push_back(edges_.size());
  }
}

}  // namespace wend
