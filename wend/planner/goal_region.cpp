#include "wend/planner/goal_region.hpp"

#include <cmath>

namespace wend {
namespace {

/// The first or last place along an axis within the tolerance; the box may be one too large.
int place_along(double at, double offset, int spacing, int places) {
  const double place = (at - offset) / spacing;
  if (std::isnan(place)) return 0;
  return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(places)));
}

}  // namespace

GoalRegion::GoalRegion(const Goal& goal, std::optional<Cell> nearest, const PlaceGrid& grid)
    : nearest_(nearest.value_or(kNowhere)),
      low_(nearest ? nearest_ : kNone),
      high_(nearest_),
      any_(nearest_),
      goal_(goal),
      grid_(grid) {
  if (!(goal.tolerance > 0)) return;
  const auto low = [&](double at, int places) {
    return std::max(place_along(at - goal.tolerance, grid.offset, grid.spacing, places), 0);
  };
  const auto high = [&](double at, int places) {
    return std::min(place_along(at + goal.tolerance, grid.offset, grid.spacing, places) + 1,
                    places - 1);
  };
  Cell first{low(goal.point.x, grid.columns), low(goal.point.y, grid.rows)};
  Cell last{high(goal.point.x, grid.columns), high(goal.point.y, grid.rows)};
  if (nearest) {
    first = {std::min(first.x, nearest->x), std::min(first.y, nearest->y)};
    last = {std::max(last.x, nearest->x), std::max(last.y, nearest->y)};
  }
  low_ = first;
  high_ = last;
  keep_if([](Cell) { return true; });
}

std::vector<Cell> goal_cells(const FreeSpace& space, const Query& query) {
  constexpr Cell kOffTheMap{-1, -1};
  std::vector<Cell> cells;
  for (const Goal& goal : query.goals) {
    const auto cell = cell_under(space, goal.point);
    const std::size_t before = cells.size();
    GoalRegion(goal, cell, cells_of(space)).for_each([&](Cell place) {
      if (space.passable(place)) cells.push_back(place);
    });
    if (cells.size() == before) cells.push_back(cell.value_or(kOffTheMap));
  }
  return cells;
}

}  // namespace wend
