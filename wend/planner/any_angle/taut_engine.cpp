#include "wend/planner/any_angle/taut_engine.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "wend/planner/any_angle/taut_path.hpp"

namespace wend {
namespace {

/// A free cell at a corner, and where the corner lies from its centre, in radians.
struct CellAtCorner {
  Cell cell;
  double heading;
};

CellAtCorner cell_at(const TautCorner& corner) {
  constexpr double kQuarter = std::numbers::pi / 4;
  const Cell high_right{corner.x, corner.y};
  const Cell low_right{corner.x, corner.y - 1};
  switch (corner.blocked_cell()) {
    case BlockedCell::low_left:
      return {high_right, -3 * kQuarter};
    case BlockedCell::high_right:
      return {{corner.x - 1, corner.y - 1}, kQuarter};
    case BlockedCell::low_right:
      return {{corner.x - 1, corner.y}, -kQuarter};
    case BlockedCell::high_left:
      return {low_right, 3 * kQuarter};
    case BlockedCell::gap:
      break;
  }
  return corner.rising == 1 ? CellAtCorner{high_right, -3 * kQuarter}
                            : CellAtCorner{low_right, 3 * kQuarter};
}

}  // namespace

/// Passes the events on.
class TautEngine::Watcher {
 public:
  Watcher(const TautEngine& engine, SearchObserver& observer)
      : engine_(engine), observer_(observer) {}

  void on_generate(TautSearch::Id id) { observer_.on_generate(engine_.event(id)); }
  void on_relax(TautSearch::Id id) { observer_.on_relax(engine_.event(id)); }
  void on_expand(TautSearch::Id id) { observer_.on_expand(engine_.event(id)); }

 private:
  const TautEngine& engine_;
  SearchObserver& observer_;
};

TautEngine::TautEngine(FreeSpace space, Adjacency adjacency,
                       std::shared_ptr<PreparedSight> prepared)
    : space_(std::move(space)),
      adjacency_(adjacency),
      prepared_(std::move(prepared)),
      portals_(prepared_->portals(space_, adjacency_)),
      search_(portals_, space_.passable()) {}

template <class Action>
void TautEngine::watched(Action&& action) {
  if (observer_ == nullptr) {
    action(TautSearch::NoWatcher{});
  } else {
    action(Watcher(*this, *observer_));
  }
}

void TautEngine::begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
                       SearchObserver* observer) {
  observer_ = observer;
  limits_ = limits;
  if (!search_.knows_all()) prepare();
  goal_points_.clear();
  for (const GoalRegion& region : goals) goal_points_.push_back(region.goal().point);
  const SightPoint from = search_.sight_point(start_, start);
  watched([&](auto&& watcher) { search_.begin(from, goals, limits_, watcher); });
}

/// Takes at most half of the time that there is.
void TautEngine::prepare() {
  constexpr double kShare = 0.5;
  prepared_->count(portals_, search_.take_looks());
  const double begun = limits_.now();
  auto map = prepared_->map(portals_, [&](double) {
    if (limits_.cancel != nullptr && limits_.cancel->load(std::memory_order_relaxed)) return false;
    return !limits_.timed() || limits_.now() - begun < kShare * limits_.seconds;
  });
  if (map != nullptr) search_.learn(std::move(map));
  if (limits_.timed()) limits_.seconds -= limits_.now() - begun;
}

SearchOutcome TautEngine::step() {
  watched([&](auto&& watcher) { search_.step(watcher); });
  return search_.outcome();
}

SearchOutcome TautEngine::run() {
  watched([&](auto&& watcher) {
    while (search_.outcome() == SearchOutcome::running) search_.step(watcher);
  });
  return search_.outcome();
}

OpenList TautEngine::open_list(std::size_t most) const {
  OpenList list;
  list.count = search_.for_each_open(
      most, [&](TautSearch::Id id) { list.entries.push_back({event(id), OpenTie::none}); });
  return list;
}

SearchEvent TautEngine::event(TautSearch::Id id) const {
  struct Seat {
    Cell cell;
    std::optional<double> heading;
  };
  const auto place = [this](TautSearch::Id state) {
    if (!search_.is_corner(state)) return Seat{search_.end(state).cell, {}};
    const CellAtCorner at = cell_at(search_.corner(state));
    return Seat{at.cell, at.heading};
  };
  const double g = search_.g(id);
  const double h = search_.h(id);
  const Seat here = place(id);
  SearchEvent event{here.cell, {}, g, h, g + h, here.heading};
  if (search_.is_start(id)) return event;
  const Seat parent = place(search_.parent(id));
  event.parent = parent.cell;
  event.parent_heading = parent.heading;
  return event;
}

/// The search rounds points of the query to its steps. The path begins and ends at the points themselves, unless one of
/// these lines then cuts a corner by a part of a step.
void TautEngine::write_path(Path& path) const {
  const TautSearch::Id goal = search_.goal();
  const bool rounded =
      end_point(search_.start(), Ends::of_query) != search_.point(search_.start()) ||
      end_point(goal, Ends::of_query) != search_.point(goal);
  if (rounded) {
    write_taut(path, Ends::of_query);
    if (disc_fits_along_path(space_, path, adjacency_)) return;
  }
  write_taut(path, Ends::of_search);
  if (space_.is_point() || disc_fits_along_path(space_, path, adjacency_)) return;
  pull_trail(path);
}

void TautEngine::write_taut(Path& path, Ends ends) const {
  path.clear();
  TautSearch::Id last = search_.goal();
  path.go_to(end_point(last, ends));
  if (search_.is_start(last)) return;
  TautSearch::Id id = search_.parent(last);
  for (; !search_.is_start(id); id = search_.parent(id)) {
    if (search_.goes_straight_on(last, id, search_.parent(id))) continue;
    path.go_to(search_.point(id));
    last = id;
  }
  path.go_to(end_point(id, ends));
  path.reverse();
}

Point TautEngine::end_point(TautSearch::Id id, Ends ends) const {
  const SightPoint& found = search_.end(id);
  if (ends == Ends::of_search) return found.point();
  if (search_.is_start(id)) return start_;
  for (const Point goal : goal_points_) {
    const auto cell = cell_under(space_, goal);
    if (cell && search_.sight_point(goal, *cell) == found) return goal;
  }
  return found.point();
}

/// In place of a path that does not fit.
void TautEngine::pull_trail(Path& path) const {
  std::vector<std::uint32_t> corners;
  for (TautSearch::Id id = search_.parent(search_.goal()); !search_.is_start(id);
       id = search_.parent(id)) {
    corners.push_back(id);
  }
  std::ranges::reverse(corners);
  write_pulled_trail(space_, adjacency_, search_.portals(), search_.cell_of_start(), corners,
                     search_.end(search_.goal()).cell, path);
}

}  // namespace wend
