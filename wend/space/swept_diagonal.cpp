#include "wend/space/swept_diagonal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace wend {
namespace {

/// Squared distance, in half-cells, from the centre of cell (0, 0) to a closed square.
int squared_distance_to_centre(Cell square) {
  const auto along = [](int cells) { return cells == 0 ? 0 : 2 * std::abs(cells) - 1; };
  return along(square.x) * along(square.x) + along(square.y) * along(square.y);
}

/// Twice the squared distance, in half-cells, from the segment between the centres of (0, 0) and
/// (1, 1) to a closed square: an end of the segment or a corner of the square is where they are
/// nearest. (A square that the segment crosses holds an end or touches it with a corner.)
int twice_squared_distance_to_way(Cell square) {
  int least = 2 * std::min(squared_distance_to_centre(square),
                           squared_distance_to_centre({square.x - 1, square.y - 1}));
  // In half-cells from the first centre the way is (t, t) for t in [0, 2], and the corners of
  // squares are odd. A corner (u, v) that projects onto the way is |u - v| / sqrt(2) from it.
  for (const int u : {2 * square.x - 1, 2 * square.x + 1}) {
    for (const int v : {2 * square.y - 1, 2 * square.y + 1}) {
      if (u + v >= 0 && u + v <= 4) least = std::min(least, (u - v) * (u - v));
    }
  }
  return least;
}

}  // namespace

SweptDiagonal::SweptDiagonal(const FreeSpace& space, bool cuts_corners)
    : space_(space), needed_(cuts_corners && space.radius_in_cells() > 0) {
  if (!needed_) return;
  const int reach = static_cast<int>(std::ceil(space.radius_in_cells())) + 2;
  const bool y_up = space.map().frame().y_up;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Cell square{x, y};
      const bool near_the_ends = !space.far_enough(squared_distance_to_centre(square)) ||
                                 !space.far_enough(squared_distance_to_centre({x - 1, y - 1}));
      if (near_the_ends || space.far_enough(twice_squared_distance_to_way(square) / 2.0)) continue;
      for (int direction = 0; direction < kDirections; ++direction) {
        const Cell along = step({}, static_cast<Direction>(direction), y_up);
        if (along.x == 0 || along.y == 0) continue;
        threatening_[static_cast<std::size_t>(direction)].push_back({x * along.x, y * along.y});
      }
    }
  }
}

bool SweptDiagonal::free(Cell from, Direction diagonal) const {
  const auto& squares = threatening_[static_cast<std::size_t>(diagonal)];
  return std::none_of(squares.begin(), squares.end(), [&](Cell offset) {
    const Cell square{from.x + offset.x, from.y + offset.y};
    return space_.obstacles().contains(square) && space_.obstacles()[square];
  });
}

}  // namespace wend
