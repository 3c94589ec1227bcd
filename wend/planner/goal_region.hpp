#pragma once

// GoalRegion: the places at which a goal lets a path end: the one that stands for its point, and those within
// its tolerance. This is the only code that makes places of a tolerance.
//
//   wend::GoalRegion region(goal, cell_under(space, goal.point), cells_of(space));
//   if (!region.keep_if([&](wend::Cell cell) { return space.passable(cell); }))
//     return wend::Status::goal_blocked;
//
// Places are numbered like cells. A PlaceGrid says which points they are.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class GoalRegion {
 public:
  /// One place.
  explicit GoalRegion(Cell place) : GoalRegion(place, centre_of(place)) {}

  /// `nearest` stands for the goal's point; nothing if that is not on the map.
  GoalRegion(const Goal& goal, std::optional<Cell> nearest, const PlaceGrid& grid);

  /// One place that stands for a point.
  GoalRegion(Cell place, Point point)
      : nearest_(place), low_(place), high_(place), any_(place), goal_(point) {}

  /// The goal, without its heading if that does not matter.
  const Goal& goal() const { return goal_; }

  bool empty() const { return low_.x > high_.x; }
  /// Is there one place, in O(1)? The answer may be no although there is.
  bool is_one_place() const { return low_ == high_; }
  /// One of the places; of those kept, if keep_if() was called.
  Cell any() const { return any_; }
  /// The place that stands for the goal's point; nothing if that is not on the map.
  std::optional<Cell> nearest() const {
    return nearest_ == kNowhere ? std::nullopt : std::optional(nearest_);
  }

  /// O(1). Also true for places that keep_if() refused; no path leads there.
  bool contains(Cell place) const {
    return place == nearest_ || (in_box(place) && goal_.reaches(grid_.point(place)));
  }

  /// The place of the bounding box that is nearest to a place: an estimate of the way to it is a consistent
  /// estimate of the way to the region. O(1).
  Cell nearest_in_box(Cell place) const {
    return {std::clamp(place.x, low_.x, high_.x), std::clamp(place.y, low_.y, high_.y)};
  }

  /// Visits every place once, the nearest first, then row by row. O(places of the bounding box).
  template <class Visit>
  void for_each(Visit&& visit) const {
    if (in_box(nearest_)) visit(nearest_);
    for (int y = low_.y; y <= high_.y; ++y) {
      for (int x = low_.x; x <= high_.x; ++x) {
        const Cell place{x, y};
        if (place != nearest_ && goal_.reaches(grid_.point(place))) visit(place);
      }
    }
  }

  /// Makes the bounding box that of the accepted places. False if there are none.
  template <class Accept>
  bool keep_if(Accept&& accept) {
    bool any = false;
    Cell low;
    Cell high;
    for_each([&](Cell place) {
      if (!accept(place)) return;
      if (!any) low = high = any_ = place;
      low = {std::min(low.x, place.x), std::min(low.y, place.y)};
      high = {std::max(high.x, place.x), std::max(high.y, place.y)};
      any = true;
    });
    low_ = any ? low : kNone;
    high_ = any ? high : kNowhere;
    return any;
  }

  /// Have they the same places? Where a point lies in its only place does not matter.
  friend bool operator==(const GoalRegion& a, const GoalRegion& b) {
    const bool points_matter = a.goal_.tolerance > 0 || b.goal_.tolerance > 0;
    return a.nearest_ == b.nearest_ && a.low_ == b.low_ && a.high_ == b.high_ && a.any_ == b.any_ &&
           (!points_matter || (a.goal_ == b.goal_ && a.grid_ == b.grid_));
  }

 private:
  static constexpr Cell kNowhere{-1, -1};  // not a place
  static constexpr Cell kNone{0, 0};       // with kNowhere: an empty box

  bool in_box(Cell place) const {
    return place.x >= low_.x && place.x <= high_.x && place.y >= low_.y && place.y <= high_.y;
  }

  Cell nearest_;
  Cell low_;
  Cell high_;
  Cell any_;
  Goal goal_;
  PlaceGrid grid_;
};

/// Is it finite, and so near to a map that a Cell can hold it?
inline bool is_near_a_map(const Goal& goal) {
  constexpr double kMost = 1e9;
  return std::abs(goal.point.x) < kMost && std::abs(goal.point.y) < kMost &&
         std::isfinite(goal.heading.value_or(0));
}

/// Is a place in one of the regions? O(regions).
inline bool any_contains(std::span<const GoalRegion> regions, Cell place) {
  return std::ranges::any_of(regions,
                             [place](const GoalRegion& region) { return region.contains(place); });
}

/// Appends the cells at which a path of steps from `start` can first enter the regions: those open(cell) with
/// an open neighbour in none of them; the start alone, if it is in one. So O(circumference) of them. `open` is
/// also asked about cells just off the map.
template <class Open>
void append_entrances(std::span<const GoalRegion> regions, Cell start, Open&& open,
                      std::vector<Cell>& entrances) {
  if (any_contains(regions, start)) {
    entrances.push_back(start);
    return;
  }
  const auto is_entrance = [&](Cell cell) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.x + dx, cell.y + dy};
        if (open(next) && !any_contains(regions, next)) return true;
      }
    }
    return false;
  };
  for (const GoalRegion& region : regions) {
    region.for_each([&](Cell cell) {
      if (region.is_one_place() || (open(cell) && is_entrance(cell))) entrances.push_back(cell);
    });
  }
}

/// The cells of all goals of a query where the robot may be, at most one of each; of a goal without any, the
/// cell of its point, or one off the map.
WEND_API std::vector<Cell> goal_cells(const FreeSpace& space, const Query& query);

}  // namespace wend
