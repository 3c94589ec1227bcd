#pragma once

// TautSearch: A* on the corners of a map, from a point of a cell to the nearest of some others: finds the shortest path
// of a point at any angle. Its states are the start, corners, and the goals.
//
// At first it looks around starts and goals in each query. Ahead of a path to a corner it glances a few times; then it
// looks around that corner, once in all queries (TautGraph). When it has a TautMap, it looks all of that up. A path goes on from a corner only as taut ones do. Into a dead end it goes only
// where a goal lies: with a map, the edges of dead ends that lead to a goal are marked, backwards from the goals. The
// paths are the same with a map and without.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/planner/goal_cells.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/min_heap.hpp"
#include "wend/sight/taut_graph.hpp"
#include "wend/sight/taut_map.hpp"

namespace wend {

class TautSearch {
 public:
  /// A state: a corner, or the start or a goal, which come behind all corners.
  using Id = std::uint32_t;

  /// The default watcher. It does nothing.
  struct NoWatcher {
    void on_generate(Id) const {}
    void on_relax(Id) const {}
    void on_expand(Id) const {}
  };

  explicit TautSearch(std::shared_ptr<const Portals> portals, const BitGrid& free);

  /// From the next search on, with what is known of the same portals.
  void learn(std::shared_ptr<const TautMap> map);
  bool knows_all() const { return map_ != nullptr; }
  /// How often it has looked around a cell or a corner since it was last asked.
  std::uint64_t take_looks();

  /// The path is to begin at the start, and to end at the point of a goal, or at the centre of a cell within its
  /// tolerance.
  template <class Watcher>
  void begin(const SightPoint& start, std::span<const GoalRegion> goals, const Limits& limits,
             Watcher&& watcher);
  template <class Watcher>
  void step(Watcher&& watcher);

  SearchOutcome outcome() const { return outcome_; }
  const SearchMetrics& metrics() const { return metrics_; }
  const Portals& portals() const { return *portals_; }

  bool is_corner(Id id) const { return id < corners_; }
  const TautCorner& corner(Id id) const { return portals().corners()[id]; }
  /// The start or a goal.
  const SightPoint& end(Id id) const {
    return id == start_id() ? start_ : goal_ends_[id - start_id() - 1];
  }
  Cell cell_of_start() const { return start_.cell; }
  /// In grid coordinates.
  Point point(Id id) const;
  /// Does a path go straight on at b, from a to c? Exact.
  bool goes_straight_on(Id a, Id b, Id c) const;
  /// The point of a free cell as it begins and ends lines of sight.
  SightPoint sight_point(Point point, Cell cell) const {
    return SightPoint::at(point, cell, finest_);
  }
  bool is_start(Id id) const { return id == start_id(); }
  Id start() const { return start_id(); }

  Id parent(Id id) const { return nodes_[id].parent; }
  double g(Id id) const { return nodes_[id].g; }
  double h(Id id) const;
  /// The estimate from the centre of a cell to the goals; 0 before the first search.
  double h(Cell cell) const { return goal_ends_.empty() ? 0 : h(centre_of(cell), cell); }

  /// The goal that was found; the start if it is one.
  Id goal() const { return goal_; }

  /// Calls visit(id) for the open states, at most `most`, the next one first. Returns how many there are.
  template <class Visit>
  std::uint64_t for_each_open(std::size_t most, Visit&& visit) const;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Node {
    double g = 0;
    double f = kClosed;
    Id parent = kNone;
    std::uint32_t edge = kNone;      // by which it was reached, if it is known
    std::uint32_t generation = 0;    // of the search that reached it
    std::uint32_t sees_goal_in = 0;  // the last search in which it has seen a goal
  };
  static constexpr double kClosed = -1;
  static constexpr std::uint32_t kLive = UINT32_MAX;  // not in a dead end

  /// The nearest goal that a corner sees.
  struct GoalInSight {
    double length = 0;
    std::uint32_t goal = 0;
  };

  struct Open {
    double f;
    Id id;

    /// Of equal estimates a goal first.
    friend bool operator<(const Open& a, const Open& b) {
      return a.f != b.f ? a.f < b.f : a.id > b.id;
    }
  };

  Id start_id() const { return corners_; }
  Id goal_id(std::size_t index) const { return corners_ + 1 + static_cast<Id>(index); }
  double h(Point point, Cell near) const;
  /// From a start or goal to a corner.
  Ray ray_to(Id id, const SightPoint& end) const {
    return {end.scale * corner(id).x - end.x, end.scale * corner(id).y - end.y};
  }
  /// A state in steps of the finest scale, which start and goals have as well.
  Ray steps(Id id) const;

  void begin_generation();
  void find_goals(std::span<const GoalRegion> goals);
  void add_goal(const SightPoint& end);
  void look_around_goals();
  bool sees_goal(Id corner) const { return nodes_[corner].sees_goal_in == generation_; }
  void mark_ways_to(const SightPoint& goal, Id corner);
  /// Can no path to a goal go on along an edge?
  bool leads_nowhere(std::uint32_t edge) const {
    if (map_ != nullptr) return marks_[edge] != kLive && marks_[edge] != generation_;
    return graph_->is_known_end(graph_->edge(edge)) && !sees_goal(graph_->edge(edge).to);
  }
  bool is_stale(const Open& open) const { return nodes_[open.id].f != open.f; }
  void push(const Open& open);
  Open pop();
  /// Without states that were reached again at less cost.
  bool any_open();

  template <class Watcher>
  void reach(Id id, double g, Id parent, std::uint32_t edge, Watcher& watcher);
  template <class Watcher>
  void expand_start(Watcher& watcher);
  template <class Watcher>
  void expand_corner(Id id, Watcher& watcher);

  /// Calls tell(corner, how far it is) for the corners that a start or goal sees.
  template <class Tell>
  void look_around(const SightPoint& end, Tell&& tell);
  /// That by which the search came to a corner.
  Ray ray_into(Id id, const Node& node) const;
  TautGraph::Edges ahead_of(Id id, const Node& node);

  std::shared_ptr<const Portals> portals_;
  std::shared_ptr<const TautMap> map_;
  std::optional<TautGraph> learned_;  // without a map
  const TautGraph* graph_ = nullptr;  // the one of these two
  CornerSweep sweep_;
  std::uint64_t looks_ = 0;    // around cells
  std::uint64_t counted_ = 0;  // looks that have been taken
  const BitGrid* free_;
  Id corners_;
  std::vector<Node> nodes_;                  // of corners, the start, goals
  std::vector<GoalInSight> goals_in_sight_;  // of corners
  std::vector<std::uint32_t>
      marks_;  // of the edges of a map: kLive, or the search in which it leads to a goal
  std::vector<std::uint32_t> to_mark_;  // edges away from a goal
  std::uint32_t generation_ = 0;
  std::vector<Open> open_;    // a heap
  std::optional<Open> next_;  // the least of those that the last expansion reached, beside the heap
  std::int64_t finest_;       // scale of ends
  SightPoint start_ = SightPoint::centre({});
  bool is_at_goal_ = false;  // does the path end where it begins?
  std::vector<SightPoint> goal_ends_;
  GoalCells goals_;
  double goal_slack_ = 0;  // how much nearer than the centre of its cell a goal may be
  double shortest_ = 0;    // path to a goal that has been reached
  Id goal_ = kNone;
  SearchOutcome outcome_ = SearchOutcome::running;
  SearchMetrics metrics_;
  LimitCheck limits_;
};

template <class Watcher>
void TautSearch::begin(const SightPoint& start, std::span<const GoalRegion> goals,
                       const Limits& limits, Watcher&& watcher) {
  begin_generation();
  start_ = start;
  find_goals(goals);
  limits_.begin(limits);
  outcome_ = SearchOutcome::running;
  metrics_ = {};
  open_.clear();
  next_.reset();
  shortest_ = std::numeric_limits<double>::infinity();
  reach(start_id(), 0, kNone, kNone, watcher);
}

inline double TautSearch::h(Point point, Cell near) const {
  const auto to = [point](Point goal) {
    const double x = goal.x - point.x;
    const double y = goal.y - point.y;
    return std::sqrt(x * x + y * y);
  };
  if (goal_ends_.size() == 1) return to(goal_ends_.front().point());
  const double to_centre = goals_.least(near, [&](Cell goal) { return to(centre_of(goal)); });
  return std::max(0.0, to_centre - goal_slack_);
}

inline double TautSearch::h(Id id) const {
  if (id > start_id()) return 0;
  return h(point(id), is_corner(id) ? Cell{corner(id).x, corner(id).y} : start_.cell);
}

inline Point TautSearch::point(Id id) const {
  if (!is_corner(id)) return end(id).point();
  return {static_cast<double>(corner(id).x), static_cast<double>(corner(id).y)};
}

/// Most expansions go on from the state that the one before reached: it need not pass the heap.
inline void TautSearch::push(const Open& open) {
  if (!next_) {
    next_ = open;
    return;
  }
  min_heap::push(open_, std::max(open, *next_));
  next_ = std::min(open, *next_);
}

inline TautSearch::Open TautSearch::pop() {
  if (!next_) return min_heap::pop(open_);
  Open least = *next_;
  next_.reset();
  if (!open_.empty() && open_.front() < least) {
    std::swap(open_.front(), least);
    min_heap::sift_down(open_, 0);
  }
  return least;
}

inline bool TautSearch::any_open() {
  if (next_ && is_stale(*next_)) next_.reset();
  while (!open_.empty() && is_stale(open_.front())) min_heap::pop(open_);
  return next_ || !open_.empty();
}

template <class Watcher>
void TautSearch::step(Watcher&& watcher) {
  if (outcome_ != SearchOutcome::running) return;
  if (limits_.due(metrics_.expanded)) outcome_ = limits_.look(metrics_.expanded);
  if (outcome_ != SearchOutcome::running) return;
  const Id id = pop().id;
  nodes_[id].f = kClosed;
  ++metrics_.expanded;
  watcher.on_expand(id);
  if (id > start_id() || (id == start_id() && is_at_goal_)) {
    goal_ = id;
    outcome_ = SearchOutcome::found;
  } else if (id == start_id()) {
    expand_start(watcher);
  } else {
    expand_corner(id, watcher);
  }
  if (outcome_ == SearchOutcome::running && !any_open()) outcome_ = SearchOutcome::exhausted;
}

template <class Watcher>
void TautSearch::reach(Id id, double g, Id parent, std::uint32_t edge, Watcher& watcher) {
  Node& node = nodes_[id];
  const bool is_new = node.generation != generation_;
  if (!is_new && (node.f == kClosed || g >= node.g)) return;
  const double f = g + h(id);
  if (f > shortest_) return;
  node = {g, f, parent, edge, generation_, node.sees_goal_in};
  if (id > start_id()) shortest_ = g;
  push({f, id});
  if (!is_new) return watcher.on_relax(id);
  ++metrics_.generated;
  metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
  watcher.on_generate(id);
}

template <class Watcher>
void TautSearch::expand_start(Watcher& watcher) {
  bool sees_all = true;
  for (std::size_t i = 0; i < goal_ends_.size(); ++i) {
    if (portals().sees(start_, goal_ends_[i])) {
      reach(goal_id(i), distance(start_.point(), goal_ends_[i].point()), start_id(), kNone,
            watcher);
    } else {
      sees_all = false;
    }
  }
  if (sees_all) return;
  look_around_goals();
  look_around(start_, [&](std::uint32_t corner, double length) {
    reach(corner, length, start_id(), kNone, watcher);
  });
}

template <class Watcher>
void TautSearch::expand_corner(Id id, Watcher& watcher) {
  const Node node = nodes_[id];
  if (sees_goal(id)) {
    const GoalInSight& sight = goals_in_sight_[id];
    reach(goal_id(sight.goal), node.g + sight.length, id, kNone, watcher);
  }
  if (learned_ && learned_->is_seldom_asked(id)) {
    return learned_->glance_ahead(id, ray_into(id, node), [&](Id next, double length) {
      reach(next, node.g + length, id, kNone, watcher);
    });
  }
  const TautGraph::Edges ahead = ahead_of(id, node);
  for (std::uint32_t i = ahead.begin; i < ahead.end; ++i) {
    if (leads_nowhere(i)) continue;
    const TautGraph::Edge& edge = graph_->edge(i);
    reach(edge.to, node.g + edge.length, id, i, watcher);
  }
}

template <class Tell>
void TautSearch::look_around(const SightPoint& end, Tell&& tell) {
  const auto steps = static_cast<double>(end.scale);
  const auto told = [&](std::uint32_t id, Ray ray) {
    tell(id, std::sqrt(static_cast<double>(ray.x * ray.x + ray.y * ray.y)) / steps);
  };
  const bool is_centre = end == SightPoint::centre(end.cell);
  if (map_ == nullptr || !is_centre) {
    ++looks_;
    return sweep_.from_point(end, told);
  }
  map_->for_each_seen(end.cell, [&](std::uint32_t id) { told(id, ray_to(id, end)); });
}

template <class Visit>
std::uint64_t TautSearch::for_each_open(std::size_t most, Visit&& visit) const {
  std::vector<Open> open = open_;
  if (next_) min_heap::push(open, *next_);
  std::uint64_t count = 0;
  while (!open.empty()) {
    const Open next = min_heap::pop(open);
    if (is_stale(next)) continue;
    if (count++ < most) visit(next.id);
  }
  return count;
}

}  // namespace wend
