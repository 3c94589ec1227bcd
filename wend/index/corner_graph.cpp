#include "wend/index/corner_graph.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>

#include "wend/geometry/direction.hpp"
#include "wend/index/diagonal_walk.hpp"
#include "wend/index/rays.hpp"

namespace wend {
namespace {

int steps_between(Cell a, Cell b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); }

/// Finds the neighbours of one corner after the other.
class EdgeScan {
 public:
  explicit EdgeScan(const Corners& corners)
      : corners_(corners), rays_(corners.passable(), Rays::Stops::every_corner) {}

  void append_neighbours(Cell from, std::vector<CornerEdge>& edges) {
    from_ = from;
    edges_ = &edges;
    for (const Direction straight : kStraightDirections) scan_ray(from, straight, kUnbounded);
    for (const Direction diagonal : kDiagonalDirections) scan_quadrant(diagonal);
  }

 private:
  static constexpr int kUnbounded = std::numeric_limits<int>::max();

  /// The corners between a diagonal and the two straight directions beside it. What a ray meets
  /// hides what lies farther out on the rays of the cells further along.
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

  int clear_steps(Direction straight) const {
    return steps_between(from_, rays_.end(from_, straight)) - 1;
  }

  /// Takes the corner that a ray stops at, if it does within `reach` steps. Says how many steps it
  /// is clear for.
  int scan_ray(Cell cell, Direction straight, int reach) {
    const Cell end = rays_.end(cell, straight);
    const int steps = steps_between(cell, end);
    if (steps <= reach) append_if_corner(end);
    return steps - 1;
  }

  bool append_if_corner(Cell cell) {
    const std::uint32_t corner = corners_.number(cell);
    if (corner == Corners::kNone) return false;
    edges_->push_back({corner, octile_cost<CornerCost>(from_, cell)});
    return true;
  }

  const Corners& corners_;
  Rays rays_;
  Cell from_;
  std::vector<CornerEdge>* edges_ = nullptr;
};

}  // namespace

CornerGraph::CornerGraph(Corners corners) : corners_(std::move(corners)), begins_{0} {
  begins_.reserve(size() + 1);
  EdgeScan scan(corners_);
  for (std::uint32_t corner = 0; corner < size(); ++corner) {
    scan.append_neighbours(corners_.cell(corner), edges_);
    begins_.push_back(edges_.size());
  }
}

}  // namespace wend
