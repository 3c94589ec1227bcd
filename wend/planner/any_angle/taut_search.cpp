#include "wend/planner/any_angle/taut_search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace wend {

TautSearch::TautSearch(std::shared_ptr<const Portals> portals, const BitGrid& free)
    : portals_(std::move(portals)),
      learned_(portals_),
      graph_(&*learned_),
      sweep_(*portals_),
      free_(&free),
      corners_(static_cast<Id>(portals_->corners().size())),
      nodes_(std::size_t{corners_} + 2),
      goals_in_sight_(corners_),
      finest_(SightPoint::finest(std::max(free.width(), free.height()))) {}

void TautSearch::learn(std::shared_ptr<const TautMap> map) {
  map_ = std::move(map);
  graph_ = &map_->graph();
  learned_.reset();
  marks_.resize(graph_->edges());
  for (std::uint32_t id = 0; id < marks_.size(); ++id) {
    marks_[id] = graph_->edge(id).dead_end != 0 ? 0 : kLive;
  }
  to_mark_.reserve(graph_->edges());
}

std::uint64_t TautSearch::take_looks() {
  const std::uint64_t all = looks_ + (learned_ ? learned_->looks() : 0);
  return all - std::exchange(counted_, all);
}

Ray TautSearch::ray_into(Id id, const Node& node) const {
  if (is_start(node.parent)) return ray_to(id, start_);
  const TautCorner& at = corner(id);
  const TautCorner& from = corner(node.parent);
  return {std::int64_t{at.x} - from.x, std::int64_t{at.y} - from.y};
}

TautGraph::Edges TautSearch::ahead_of(Id id, const Node& node) {
  if (node.edge == kNone) {
    const Ray ray = ray_into(id, node);
    return learned_ ? learned_->ahead_of(id, ray) : graph_->known_ahead_of(id, ray);
  }
  return learned_ ? learned_->ahead(node.edge, ray_into(id, node)) : graph_->known_ahead(node.edge);
}

void TautSearch::begin_generation() {
  if (generation_ + 1 == kLive) {
    for (Node& node : nodes_) node.generation = node.sees_goal_in = 0;
    std::ranges::replace_if(marks_, [](std::uint32_t mark) { return mark != kLive; }, 0U);
    generation_ = 0;
  }
  ++generation_;
}

void TautSearch::find_goals(std::span<const GoalRegion> goals) {
  goals_.assign(goals);
  goal_ends_.clear();
  is_at_goal_ = false;
  goal_slack_ = 0;
  for (const GoalRegion& region : goals) {
    region.for_each([&](Cell cell) {
      if (!free_->contains(cell) || !(*free_)[cell]) return;
      const SightPoint centre = SightPoint::centre(cell);
      const SightPoint end =
          cell == region.nearest() ? sight_point(region.goal().point, cell) : centre;
      add_goal(end);
      if (end != centre && region.goal().reaches(centre.point())) add_goal(centre);
    });
    is_at_goal_ =
        is_at_goal_ || (region.contains(start_.cell) && region.goal().reaches(start_.point()));
  }
  if (goals.size() > 1) {  // they may overlap
    const auto order = [](const SightPoint& end) {
      return std::tuple(end.cell, end.scale, end.x, end.y);
    };
    std::ranges::sort(goal_ends_, {}, order);
    const auto repeated = std::ranges::unique(goal_ends_);
    goal_ends_.erase(repeated.begin(), repeated.end());
  }
  const std::size_t states = std::size_t{corners_} + 1 + goal_ends_.size();
  if (nodes_.size() < states) nodes_.resize(states);
}

void TautSearch::add_goal(const SightPoint& end) {
  goal_ends_.push_back(end);
  goal_slack_ = std::max(goal_slack_, distance(end.point(), centre_of(end.cell)));
  is_at_goal_ = is_at_goal_ || end == start_;
}

Ray TautSearch::steps(Id id) const {
  if (is_corner(id)) return {finest_ * corner(id).x, finest_ * corner(id).y};
  const SightPoint at = end(id).scaled(finest_);
  return {at.x, at.y};
}

bool TautSearch::goes_straight_on(Id a, Id b, Id c) const {
  const Ray from = steps(a);
  const Ray at = steps(b);
  const Ray to = steps(c);
  return cross({at.x - from.x, at.y - from.y}, {to.x - at.x, to.y - at.y}) == 0;
}

void TautSearch::look_around_goals() {
  for (std::size_t i = 0; i < goal_ends_.size(); ++i) {
    look_around(goal_ends_[i], [&](std::uint32_t corner, double length) {
      if (map_ != nullptr) mark_ways_to(goal_ends_[i], corner);
      GoalInSight& sight = goals_in_sight_[corner];
      if (sees_goal(corner) && sight.length <= length) return;
      sight = {length, static_cast<std::uint32_t>(i)};
      nodes_[corner].sees_goal_in = generation_;
    });
  }
}

/// The edges of dead ends by which a path comes to a corner from where it goes on to the goal, and those before them.
void TautSearch::mark_ways_to(const SightPoint& goal, Id corner) {
  const auto mark_behind = [this](TautGraph::Edges away) {
    for (std::uint32_t i = away.begin; i < away.end; ++i) {
      const std::uint32_t towards = graph_->edge(i).back;
      if (marks_[towards] == kLive || marks_[towards] == generation_) continue;
      marks_[towards] = generation_;
      to_mark_.push_back(i);
    }
  };
  mark_behind(graph_->known_ahead_of(corner, ray_to(corner, goal)));
  while (!to_mark_.empty()) {
    const std::uint32_t away = to_mark_.back();
    to_mark_.pop_back();
    mark_behind(graph_->known_ahead(away));
  }
}

}  // namespace wend
