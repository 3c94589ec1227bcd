#include "wend/analysis/widest_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "wend/base/options.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/map/grid_within.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::int64_t kNotReached = -1;

// The cost of a narrow cell: as that of a detour of ten million wide cells. A CostMap can hold it.
constexpr double kDear = 1e7;

/// A cell on the frontier, and how wide a robot gets there: the widest first, then what is nearer to
/// the goal.
struct Reached {
  std::uint32_t width;  // as squared half-cells
  int to_goal;
  Cell cell;

  friend bool operator<(const Reached& a, const Reached& b) {
    if (a.width != b.width) return a.width > b.width;
    if (a.to_goal != b.to_goal) return a.to_goal < b.to_goal;
    return a.cell < b.cell;
  }
};

/// Prim's algorithm from the start, until it reaches the goal.
class WidestSearch {
 public:
  WidestSearch(const FreeSpace& space, Cell goal, Adjacency adjacency, DeadlineCheck check)
      : space_(space),
        goal_(goal),
        check_(check),
        stride_(adjacency == Adjacency::edges ? 2 : 1),  // even directions are straight
        widths_(grid_within<std::int64_t>(space.width(), space.height(), kNotReached, check_)) {}

  std::optional<std::uint32_t> run(Cell start) {
    if (check_.has_passed() || !space_.obstacles().make_clearance(check_)) return std::nullopt;
    const auto& clearance = space_.squared_half_cell_clearance();
    if (clearance[start] == 0 || clearance[goal_] == 0) return std::nullopt;
    // No path is wider than this. Capped by it, all that is wide enough is equally wide.
    reach(start, std::min(clearance[start], clearance[goal_]));
    while (!frontier_.empty() && !check_()) {
      const Reached next = min_heap::pop(frontier_);
      if (next.cell == goal_) return next.width;
      if (widths_[next.cell] == next.width) expand(next);
    }
    return std::nullopt;
  }

 private:
  void expand(const Reached& from) {
    for (int direction = 0; direction < kDirections; direction += stride_) {
      const Cell to = step(from.cell, static_cast<Direction>(direction));
      if (!space_.contains(to) || space_.obstacles().blocked()[to]) continue;
      reach(to, std::min(from.width, squared_half_cell_way_clearance(space_, from.cell, to)));
    }
  }

  void reach(Cell cell, std::uint32_t width) {
    if (widths_[cell] >= width) return;
    widths_[cell] = width;
    const int to_goal = std::abs(cell.x - goal_.x) + std::abs(cell.y - goal_.y);
    min_heap::push(frontier_, Reached{width, to_goal, cell});
  }

  const FreeSpace& space_;
  Cell goal_;
  DeadlineCheck check_;
  int stride_;
  Grid<std::int64_t> widths_;
  std::vector<Reached> frontier_;
};

/// The map with the cells on which no wider robot can stand so dear that the cheapest path enters as
/// few of them as it can.
/// In cells: a radius in metres may be larger than that of any Footprint.
GridMap with_narrow_cells_dear(const FreeSpace& space, std::uint32_t width, DeadlineCheck& check) {
  const GridMap& map = space.map();
  const auto& clearance = space.squared_half_cell_clearance();
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height(), 1);
  for (const Cell cell : every_cell(map)) {
    if (check()) break;
    states[cell] = map.state(cell);
    if (clearance[cell] <= width) terrain[cell] = kDear;
  }
  return *make_grid_map(states, {}, std::move(terrain));
}

Path cheapest_path(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                   const Deadline* deadline) {
  const OptionValues options{{"connectivity", std::string(choice_name(moves.connectivity))},
                             {"corner_rule", std::string(choice_name(moves.corner_rule))}};
  const auto planner = make_planner("astar", space, options);
  if (!planner) return {};
  Query query = Query::between(start, goal);
  if (deadline != nullptr) query.limits = deadline->left();
  auto plan = (*planner)->plan(query);
  return plan ? std::move(plan->path) : Path{};
}

/// The cells that a robot wider than `width` can reach from the start. O(cells).
BitGrid reach_of_a_wider_robot(const FreeSpace& space, Cell start, std::uint32_t width,
                               Adjacency adjacency, DeadlineCheck& check) {
  const int stride = adjacency == Adjacency::edges ? 2 : 1;
  BitGrid reached(space.width(), space.height());
  std::vector<Cell> open;
  const auto reach = [&](Cell from, Cell to) {
    if (reached[to] || squared_half_cell_way_clearance(space, from, to) <= width) return;
    reached.set(to, true);
    open.push_back(to);
  };
  reach(start, start);
  while (!open.empty() && !check()) {
    const Cell from = open.back();
    open.pop_back();
    for (int direction = 0; direction < kDirections; direction += stride) {
      const Cell to = step(from, static_cast<Direction>(direction));
      if (space.contains(to)) reach(from, to);
    }
  }
  return reached;
}

/// Where a wider robot is stuck that comes along the path as far as it can.
Point narrowest_point(const FreeSpace& space, std::span<const Cell> cells, std::uint32_t width,
                      Adjacency adjacency, DeadlineCheck& check) {
  if (cells.empty()) return {};
  const auto& clearance = space.squared_half_cell_clearance();
  const BitGrid wider = reach_of_a_wider_robot(space, cells.front(), width, adjacency, check);
  std::size_t next = cells.size() - 1;
  while (next > 0 && !wider[cells[next - 1]]) --next;
  const Cell to = cells[next];
  if (next == 0 || clearance[to] <= width) return centre_of(to);
  const Cell from = cells[next - 1];
  if (squared_half_cell_way_clearance(space, from, to) <= width) {
    return {(from.x + to.x + 1) / 2.0, (from.y + to.y + 1) / 2.0};
  }
  // A diagonal step: the ways around it lead over the cells beside it.
  const Cell beside{from.x, to.y};
  return centre_of(clearance[beside] <= width ? beside : Cell{to.x, from.y});
}

}  // namespace

std::optional<std::uint32_t> squared_half_cell_width(const FreeSpace& space, Cell start, Cell goal,
                                                     GridMoves moves, DeadlineCheck check) {
  if (!space.contains(start) || !space.contains(goal) || check.now()) return std::nullopt;
  return WidestSearch(space, goal, moves.adjacency(), check).run(start);
}

std::optional<WidestPath> widest_path(const FreeSpace& space, Cell start, Cell goal,
                                      GridMoves moves, DeadlineCheck check) {
  const auto width = squared_half_cell_width(space, start, goal, moves, check);
  if (!width || check.now()) return std::nullopt;
  // Where there is no obstacle, the farthest that a FreeSpace looks.
  const double cells = std::sqrt(static_cast<double>(*width)) / 2;
  const GridMap map = with_narrow_cells_dear(space, *width, check);
  if (check.now()) return std::nullopt;
  const FreeSpaceOptions options{.footprint = Footprint::disc(cells),
                                 .unknown = space.options().unknown,
                                 .outside = space.outside()};
  const Deadline never;
  const auto widest = make_free_space(Obstacles(map, options.obstacles()), options.robot(),
                                      check.deadline() == nullptr ? never : *check.deadline());
  if (!widest || check.now()) return std::nullopt;
  Path path = cheapest_path(*widest, start, goal, moves, check.deadline());
  if (check.now()) return std::nullopt;
  const Point narrowest = narrowest_point(*widest, path.cells(), *width, moves.adjacency(), check);
  if (check.now()) return std::nullopt;
  return WidestPath{distance_in_cells(*width), narrowest, std::move(path)};
}

}  // namespace wend
