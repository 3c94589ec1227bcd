#include "wend/session/closest_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/geometry/arc_distance.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend {
namespace {

constexpr double kClosestRounding = 1e-9;
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

std::vector<Goal> goals_near_a_map(const Query& query) {
  std::vector<Goal> goals;
  std::ranges::copy_if(query.goals, std::back_inserter(goals),
                       [](const Goal& goal) { return is_near_a_map(goal); });
  return goals;
}

/// The accepted cells whose middles are nearest to a point, and how far they are. `most` bounds the distance.
template <class Accept>
double add_nearest(const FreeSpace& space, Point point, double most, const Accept& accepts,
                   std::vector<Cell>& cells, DeadlineCheck& stop) {
  const auto one = nearest_accepted(space.width(), space.height(), cell_at(point), accepts, stop);
  if (!one) return kAnywhere;
  // From the middle of the point's cell another one may be nearer.
  const double reach = std::min(distance(centre_of(*one), point), most) + kClosestRounding;
  const Cell low{std::max(0, static_cast<int>(std::floor(point.x - reach - 0.5))),
                 std::max(0, static_cast<int>(std::floor(point.y - reach - 0.5)))};
  const Cell high{std::min(space.width() - 1, static_cast<int>(std::ceil(point.x + reach))),
                  std::min(space.height() - 1, static_cast<int>(std::ceil(point.y + reach)))};
  double least = reach;
  const auto first = static_cast<std::ptrdiff_t>(cells.size());
  for (int y = low.y; y <= high.y && !stop.now(); ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const double away = distance(centre_of(Cell{x, y}), point);
      if (away > least + kClosestRounding || !accepts({x, y})) continue;
      if (away < least - kClosestRounding) cells.erase(cells.begin() + first, cells.end());
      least = std::min(least, away);
      cells.push_back({x, y});
    }
  }
  return static_cast<std::ptrdiff_t>(cells.size()) == first ? kAnywhere : least;
}

/// Searches with a planner whose states have headings.
class ClosestPose {
 public:
  ClosestPose(Planner& planner, const Query& query, const Deadline& deadline)
      : planner_(planner), query_(query), asked_(goals_near_a_map(query)), stop_(&deadline) {
    query_.observer = nullptr;
    query_.on_solution = {};
  }

  std::optional<ClosestPlaces> within(double most) {
    if (asked_.empty()) return std::nullopt;
    if (try_within(0) || !(most > 0)) return places();
    double low = 0;
    double next = std::max(least_distance(), kClosestRounding);
    if (stop_.now()) return std::nullopt;
    const double farthest = std::min(most, distance_to_goals(query_.start.point(), asked_) + 2);
    // What the inscribed disc reaches is most often the answer; else it grows until something is found, and shrinks
    // to half a cell.
    while (next <= farthest + kClosestRounding) {
      if (try_within(next)) break;
      if (stop_.now()) return std::nullopt;
      low = next;
      if (next >= farthest) return std::nullopt;
      next = std::min(farthest, 1.5 * next + 1);
    }
    const bool on_lattice = planner_.place_of(kOffLattice) != kOffLattice;
    const double precision = on_lattice ? kOnLattice : kPrecision;
    while (found_ && *found_ - low > precision && low > 0 && !stop_.now()) {
      const double middle = (low + *found_) / 2;
      if (!try_within(middle)) low = middle;
    }
    settle(low, precision);
    return places();
  }

 private:
  // Cells. The places of a lattice differ by more than the second one, those of other robots lie anywhere.
  static constexpr double kPrecision = 0.5;
  static constexpr double kOnLattice = 0.02;
  static constexpr Pose kOffLattice{0.3, 0.3, 0.3};

  std::vector<Goal> goals_within(double tolerance) const {
    std::vector<Goal> goals;
    goals.reserve(asked_.size());
    for (const Goal& goal : asked_) goals.emplace_back(goal.point, tolerance);
    return goals;
  }

  bool try_within(double tolerance) {
    query_.goals = goals_within(tolerance);
    if (planner_.plan(query_, plan_) != Status::found) return false;
    const double reached = distance_to_goals(plan_.path.poses().back().point(), asked_);
    found_ = std::min(found_.value_or(kAnywhere), reached);
    tolerance_ = tolerance == 0 ? 0 : std::min(tolerance, reached);
    tried_ = tolerance;
    return true;
  }

  /// A planner looks for places within a tolerance, and may find none within one that just reaches the end of a path.
  /// Then the tolerance is one with which there was a path.
  void settle(double low, double precision) {
    if (!found_ || tolerance_ == 0 || tolerance_ == tried_) return;
    if (try_within(tolerance_ + kClosestRounding)) return;
    low = std::max(low, tolerance_);
    while (tried_ - low > precision) {
      const double middle = (low + tried_) / 2;
      if (!try_within(middle)) low = middle;
    }
    tolerance_ = tried_;
  }

  std::optional<ClosestPlaces> places() const {
    if (!found_) return std::nullopt;
    const double rounding = tolerance_ == 0 ? 0 : kClosestRounding;
    return ClosestPlaces{goals_within(tolerance_ + rounding), *found_};
  }

  /// No place is nearer: the planner has none there, or its inscribed disc cannot come there.
  double least_distance() {
    const FreeSpace& space = planner_.free_space();
    const ConnectedComponents parts(space.possible(), stop_);
    if (!parts.prepare(Adjacency::edges_and_corners, stop_)) return kAnywhere;
    const auto start = cell_under(space, query_.start.point());
    double least = kAnywhere;
    for (const Goal& goal : asked_) {
      const auto free = planner_.nearest_free(Goal(goal.point));
      double away = free ? distance(*free, goal.point) : kAnywhere;
      const double beside =
          planner_.place_grid().on_corners() ? 0.75 : 0;  // a vertex, of a cell's middle
      std::vector<Cell> cells;
      if (start && space.possible()[*start]) {
        const auto reaches = [&](Cell cell) {
          return parts.connected(cell, *start, Adjacency::edges_and_corners);
        };
        const double connected = add_nearest(space, goal.point, kAnywhere, reaches, cells, stop_);
        away = std::max(away, connected - beside);
      }
      least = std::min(least, away);
    }
    return least;
  }

  Planner& planner_;
  Query query_;
  std::vector<Goal> asked_;
  DeadlineCheck stop_;
  Plan plan_;
  std::optional<double> found_;
  double tolerance_ = 0;
  double tried_ = 0;  // the last tolerance with which there was a path
};

}  // namespace

double distance_to_goals(Point point, const std::vector<Goal>& goals) {
  double least = kAnywhere;
  for (const Goal& goal : goals) least = std::min(least, distance(point, goal.point));
  return least;
}

std::optional<ClosestPlaces> closest_cells(const Planner& planner, const Query& query, double most,
                                           const Deadline& deadline) {
  DeadlineCheck stop(&deadline);
  const FreeSpace& space = planner.free_space();
  const auto start = cell_under(space, query.start.point());
  const auto moves = planner.grid_moves();
  if (!moves || !start || !space.passable(*start)) return std::nullopt;
  const Adjacency adjacency = moves->adjacency();
  const auto reaches = [&](Cell cell) {
    return space.components().connected(cell, *start, adjacency);
  };
  double least = most;
  std::vector<Cell> cells;
  for (const Goal& goal : goals_near_a_map(query)) {
    std::vector<Cell> near;
    const double away = add_nearest(space, goal.point, least, reaches, near, stop);
    if (away > least + kClosestRounding) continue;
    if (away < least - kClosestRounding) cells.clear();
    least = away;
    cells.insert(cells.end(), near.begin(), near.end());
  }
  if (cells.empty() || stop.has_passed()) return std::nullopt;
  std::ranges::sort(cells, {}, [](Cell cell) { return std::pair(cell.y, cell.x); });
  const auto repeated = std::ranges::unique(cells);
  cells.erase(repeated.begin(), repeated.end());
  ClosestPlaces places{{}, least};
  for (const Cell cell : cells) places.goals.emplace_back(centre_of(cell));
  return places;
}

std::optional<ClosestPlaces> closest_places(Planner& planner, const Query& query, double most,
                                            const Deadline& deadline) {
  if (planner.grid_moves()) return closest_cells(planner, query, most, deadline);
  return ClosestPose(planner, query, deadline).within(most);
}

}  // namespace wend
