#include "wend/index/first_corners.hpp"

#include <algorithm>

#include "wend/geometry/direction.hpp"
#include "wend/index/diagonal_walk.hpp"

namespace wend {
namespace {

bool is_stop(const BitGrid& passable, Cell cell, Direction straight) {
  return (jump_directions(passable.block(cell)) >> quarter(straight) & 1U) != 0;
}

/// Visits every cell that has a corner in its list: back along the rays that stop there, and back
/// along the diagonals that cast them.
template <class Visit>
void visit_cells_before(const BitGrid& passable, Cell corner, Visit&& visit) {
  for (const Direction straight : kStraightDirections) {
    if (!is_stop(passable, corner, straight)) continue;
    for (Cell cell = step(corner, opposite(straight)); passable[cell];
         cell = step(cell, opposite(straight))) {
      visit(cell);
      for (const Direction diagonal : beside(straight)) {
        walk_diagonal(passable, cell, opposite(diagonal), [&](Cell start) {
          visit(start);
          return true;
        });
      }
      if (is_stop(passable, cell, straight)) break;
    }
  }
}

}  // namespace

FirstCorners::FirstCorners(const Corners& corners)
    : corners_(&corners), rays_(corners.passable(), Rays::Stops::jump_points) {}

void FirstCorners::find(Cell cell, std::vector<std::uint32_t>& out) const {
  out.clear();
  const auto cast = [&](Cell from, Direction straight) {
    const std::uint32_t corner = corners_->number(rays_.end(from, straight));
    if (corner != Corners::kNone) out.push_back(corner);
  };
  for (const Direction straight : kStraightDirections) cast(cell, straight);
  for (const Direction diagonal : kDiagonalDirections) {
    walk_diagonal(corners_->passable(), cell, diagonal, [&](Cell on_diagonal) {
      for (const Direction straight : beside(diagonal)) cast(on_diagonal, straight);
      return true;
    });
  }
  std::sort(out.begin(), out.end());
}

AllFirstCorners::AllFirstCorners(const Corners& corners)
    : width_(corners.passable().width()),
      begins_(static_cast<std::size_t>(width_) *
                  static_cast<std::size_t>(corners.passable().height()) +
              1) {
  const BitGrid& passable = corners.passable();
  const auto count = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t corner = 0; corner < count; ++corner) {
    visit_cells_before(passable, corners.cell(corner),
                       [&](Cell cell) { ++begins_[number_of(cell)]; });
  }
  std::size_t end = 0;  // filling moves each to its begin
  for (std::size_t& begin : begins_) begin = end += begin;
  corners_.resize(end);
  for (std::uint32_t corner = count; corner-- > 0;) {
    visit_cells_before(passable, corners.cell(corner),
                       [&](Cell cell) { corners_[--begins_[number_of(cell)]] = corner; });
  }
}

}  // namespace wend
