#include "wend/planner/se2/hybrid_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wend {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();
constexpr int kTraceHeadings = 12;
constexpr std::size_t kWords = 4;         // connections that are tried to a goal
constexpr std::size_t kMostHits = 2;      // connections of a trace that are kept
constexpr std::size_t kMostNarrow = 2;    // narrow places of a trace
constexpr double kShorter = 0.62;         // the next subgoal of a trace, as a share of the last one
constexpr double kSteadyGap = 0.003;      // of the cost of a path, that is not worth a search
constexpr double kGrowingGap = 0.0002;    // how that grows with each expansion since the first path
constexpr std::uint64_t kPatience = 300;  // expansions after the first path

/// The same place for a robot that looks the other way, and the same motion for it.
Pose facing_back(const Pose& pose) { return {pose.x, pose.y, wrapped_angle(pose.heading + kPi)}; }
Motion facing_back(const Motion& motion) { return {-motion.length, motion.turn, motion.course}; }

/// Does a robot face away from a pose that it is to reach?
bool faces_away(const Pose& from, const Pose& to) {
  const auto [sine, cosine] = sine_and_cosine(from.heading);
  const auto [up, along] = sine_and_cosine(to.heading);
  return sine * up + cosine * along < 0;
}

}  // namespace

HybridSearch::HybridSearch(const MotionCheck& check, const Steering& steering, GoalRing& ring,
                           const CoarseGrid& grid, const HybridResolution& resolution,
                           Direction direction)
    : check_(check),
      steering_(steering),
      grid_(grid),
      direction_(direction),
      resolution_(resolution),
      turning_(steering),
      ring_(ring),
      field_(grid),
      trace_(check, field_, std::max<double>(grid.size(), resolution.step)),
      seen_(resolution.position, resolution.headings),
      traced_(resolution.trace_spacing, kTraceHeadings) {}

void HybridSearch::begin(const Pose& first, std::span<const HybridGoal> goals,
                         SearchObserver* observer, std::function<bool()> stop) {
  Pose start = first;
  goals_ = goals;
  if (direction_ == Direction::from_goal) {
    start = facing_back(goals.front().pose);
    start_as_goal_ = goals.front();
    start_as_goal_.pose = facing_back(first);
    start_as_goal_.asked = Goal(start_as_goal_.pose);
    start_as_goal_.any_heading = false;
    goals_ = {&start_as_goal_, 1};
  }
  observer_ = observer;
  seen_.clear();
  traced_.clear();
  nodes_.clear();
  motions_.clear();
  open_.clear();
  metrics_ = {};
  best_ = kNone;
  best_cost_ = kNoWay;
  expanded_at_first_path_ = 0;
  nearest_try_ = kNoWay;
  seeds_.clear();
  for (const HybridGoal& goal : goals_) seeds_.push_back(seed_of(goal));
  field_.begin(seeds_, start.point(), std::move(stop));
  field_.settle(start.point());
  const CoarseCostField::Value h = estimate(start);
  if (!(h.cost < kNoWay)) return;
  nodes_.push_back({start, 0, h.cost, kNone, 0, 0, 0, h.exact, true, 0});
  seen_[start] = 0;
  open_.push_back({f_of(nodes_[0]), 0});
  metrics_.generated = metrics_.max_frontier = 1;
  tell(nodes_[0], false);
}

/// What the field knows of a goal: the cost of arriving with its heading, or the distance.
CoarseCostField::Seed HybridSearch::seed_of(const HybridGoal& goal) const {
  if (goal.wants_heading() && ring_.reach() > 0) {
    return {goal.pose.point(),
            [this, &goal](Point point) { return ring_.least_cost(point, goal.pose); },
            ring_.reach()};
  }
  return {goal.pose.point(),
          [&goal](Point point) { return straight_distance(point, goal.pose.point()); },
          4.0 * grid_.size()};
}

/// What it costs to arrive at a goal: next to it, where the robot drives to and fro, the table is too coarse.
double HybridSearch::arrival(const Pose& pose, const HybridGoal& goal) const {
  if (!resolution_.to_contact) return ring_.cost(pose, goal.pose);
  std::array<Connection, 1> best;
  const int count = steering_.connect(pose, goal.pose, 0, kNoWay, best);
  return count > 0 ? best[0].cost : kNoWay;
}

/// The cost of the way on the field, and of turning into it; near a goal, that of arriving there.
CoarseCostField::Value HybridSearch::estimate(const Pose& pose) const {
  CoarseCostField::Value value = field_.at(pose.point());
  if (!value.exact || !(value.cost < kNoWay)) return value;
  double arriving = kNoWay;
  for (const HybridGoal& goal : goals_) {
    const bool counts = resolution_.to_contact ? !goal.any_heading : goal.wants_heading();
    if (!counts || ring_.reach() == 0) continue;
    if (straight_distance(pose.point(), goal.pose.point()) > ring_.reach()) continue;
    arriving = std::min(arriving, arrival(pose, goal));
  }
  if (arriving < kNoWay) {
    value.cost = std::max(value.cost, arriving);
    return value;
  }
  const Point way = field_.descent(pose.point());
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  value.cost += turning_(cosine * way.x + sine * way.y);
  return value;
}

/// The longer the search has gone on since it found a path, the less it has to gain.
bool HybridSearch::may_stop(double least_f) const {
  if (best_ == kNone) return false;
  const auto since = metrics_.expanded - expanded_at_first_path_;
  if (since >= kPatience) return true;
  const double gap = kSteadyGap + kGrowingGap * static_cast<double>(since);
  return best_cost_ <= least_f * (1 + gap);
}

SearchOutcome HybridSearch::run(std::uint64_t most) {
  const std::uint64_t end = metrics_.expanded + most;
  while (!open_.empty()) {
    const Open top = open_.front();
    if (may_stop(top.f)) return SearchOutcome::found;
    if (metrics_.expanded >= end) return SearchOutcome::running;
    std::pop_heap(open_.begin(), open_.end());
    open_.pop_back();
    Node& node = nodes_[top.node];
    if (seen_[node.pose] != top.node) continue;  // a better pose has taken its place
    if (!node.exact) {
      field_.settle(node.pose.point());
      node.exact = true;
      node.h = std::max(node.h, estimate(node.pose).cost);
      if (!(node.h < kNoWay)) continue;
      const double f = f_of(node);
      if (f > top.f) {
        open_.push_back({f, top.node});
        std::push_heap(open_.begin(), open_.end());
        continue;
      }
    }
    expand(top.node);
  }
  return best_ == kNone ? SearchOutcome::exhausted : SearchOutcome::found;
}

void HybridSearch::expand(Index node) {
  ++metrics_.expanded;
  if (observer_ != nullptr) tell(nodes_[node], true);
  for (const HybridGoal& goal : goals_) {
    if (goal.accepts(nodes_[node].pose)) offer_goal(node, goal);
  }
  expand_from(node, is_near_goal(node) && is_worth_trying(node));
}

void HybridSearch::expand_from(Index node, bool to_goal) {
  const bool due = nodes_[node].traced || nodes_[node].age >= resolution_.trace_period;
  if (due) {
    nodes_[node].age = 0;
    expand_trace(node);
  }
  if (to_goal) try_goals(node);
  expand_primitives(node);
}

bool HybridSearch::is_near_goal(Index node) const {
  return nodes_[node].h < 4 * steering_.radius() + resolution_.step;
}

/// A search to contact comes past many poses that are alike: it tries the goals where it has got nearer, and
/// sometimes.
bool HybridSearch::is_worth_trying(Index node) {
  constexpr double kNearer = 0.9;
  constexpr std::uint64_t kSometimes = 16;
  if (!resolution_.to_contact) return true;
  const double h = nodes_[node].h;
  if (h >= kNearer * nearest_try_ && metrics_.expanded % kSometimes != 0) return false;
  nearest_try_ = std::min(h, nearest_try_);
  return true;
}

void HybridSearch::expand_primitives(Index node) {
  if (resolution_.to_contact) {
    for (const Motion& primitive : steering_.primitives()) expand_to_contact(node, primitive);
    return;
  }
  const double room = check_.room_at(nodes_[node].pose.point());
  const double step = room > resolution_.wide_room ? 2 * resolution_.step : resolution_.step;
  for (const Motion& primitive : steering_.primitives()) {
    const Motion motion = steering_.scaled(primitive, step);
    if (const auto cost = drive(node, {&motion, 1}, kNoWay)) add(node, {&motion, 1}, *cost, false);
  }
}

/// Adds the poses after 1, 2, 4, ... steps of a primitive, and the last one before the robot touches something, to a
/// small part of a step: in a tight slot each motion gains little more than that.
void HybridSearch::expand_to_contact(Index node, const Motion& primitive) {
  constexpr double kParts = 8;
  const double least = resolution_.step / kParts;
  const Pose from = nodes_[node].pose;
  const bool changes = gear_of(primitive) * nodes_[node].gear < 0;
  double cost = changes ? steering_.costs().gear_change : 0;
  Pose pose = from;
  double length = 0;
  bool free = true;
  for (double part = resolution_.step; part >= (free ? resolution_.step : least);) {
    const Motion whole = steering_.scaled(primitive, length + part);
    const Motion piece = part_of(whole, part / (length + part));
    const double way = way_of(pose, piece);
    if (way == MotionCheck::kBlocked) {
      free = false;
    } else {
      length += part;
      pose = pose_after(from, whole);
      cost += steering_.cost(piece, way);
      if (free || part < 2 * least) add(node, {&whole, 1}, cost, false);
    }
    if (primitive.length == 0 || std::abs(whole.turn) > kPi / 4) return;
    part = free ? length : part / 2;
  }
}

/// The cost of the way of a motion of this search's robot.
double HybridSearch::way_of(const Pose& pose, const Motion& motion) const {
  return direction_ == Direction::from_start ? check_.cost(pose, motion)
                                             : check_.cost(facing_back(pose), facing_back(motion));
}

std::optional<double> HybridSearch::drive(Index node, std::span<const Motion> motions,
                                          double limit) {
  Pose pose = nodes_[node].pose;
  int gear = nodes_[node].gear;
  double cost = 0;
  for (const Motion& motion : motions) {
    const double way = way_of(pose, motion);
    if (way == MotionCheck::kBlocked) return std::nullopt;
    const int next = gear_of(motion);
    if (next * gear < 0) cost += steering_.costs().gear_change;
    if (next != 0) gear = next;
    cost += steering_.cost(motion, way);
    if (cost >= limit) return std::nullopt;
    if (&motion != &motions.back()) pose = pose_after(pose, motion);
  }
  return cost;
}

bool HybridSearch::add(Index parent, std::span<const Motion> motions, double cost, bool traced,
                       const Pose* exactly) {
  const Node from = nodes_[parent];
  Node node = from;
  for (const Motion& motion : motions) {
    node.pose = pose_after(node.pose, motion);
    if (const int gear = gear_of(motion); gear != 0) node.gear = gear;
  }
  if (exactly != nullptr) node.pose = *exactly;
  node.g = from.g + cost;
  if (node.g >= best_cost_) return false;
  const CoarseCostField::Value h = estimate(node.pose);
  node.h = h.cost;
  node.exact = h.exact;
  if (!(node.g + node.h < best_cost_)) return false;
  std::uint32_t& seen = seen_[node.pose];
  const bool again = seen != kNone;
  if (again && nodes_[seen].g + nodes_[seen].h <= node.g + node.h) return false;
  node.traced = traced;
  node.age = static_cast<std::uint8_t>(traced ? 0 : std::min(from.age + 1, 255));
  seen = static_cast<Index>(nodes_.size());
  open_.push_back({f_of(node), seen});
  std::push_heap(open_.begin(), open_.end());
  keep(node, parent, motions);
  ++metrics_.generated;
  metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, open_.size());
  if (observer_ != nullptr) tell(node, false);
  return true;
}

void HybridSearch::keep(Node& node, Index parent, std::span<const Motion> motions) {
  node.parent = parent;
  node.first_motion = static_cast<Index>(motions_.size());
  node.motion_count = static_cast<std::uint16_t>(motions.size());
  motions_.insert(motions_.end(), motions.begin(), motions.end());
  nodes_.push_back(node);
}

void HybridSearch::expand_trace(Index node) {
  std::uint32_t& traced = traced_[nodes_[node].pose];
  if (traced != kNone) return;
  traced = node;
  const double left = trace_.follow(nodes_[node].pose.point());
  if (left < 4 * steering_.radius() + 2 * grid_.size()) try_goals(node);
  connect_trace(node);
}

/// Connects to poses on the trace: in its narrow places, then the farthest first.
void HybridSearch::connect_trace(Index node) {
  std::size_t narrow = 0;
  for (std::size_t i = 0; i < trace_.size() && narrow < kMostNarrow; ++i) {
    if (!trace_.is_narrow_at(i)) continue;
    ++narrow;
    connect_to(node, trace_.pose(i), kWords);
  }
  std::size_t hits = 0;
  auto place = static_cast<double>(trace_.size());
  for (int tries = 0; tries < 8 && place >= 2 && hits < kMostHits; ++tries) {
    const auto i = static_cast<std::size_t>(place) - 1;
    place *= kShorter;
    const Pose to = trace_.pose(i);
    if (connect_to(node, to, 1)) ++hits;
    if (faces_away(nodes_[node].pose, to)) connect_to(node, facing_back(to), 1);
  }
}

bool HybridSearch::connect_to(Index node, const Pose& to, std::size_t words, bool exactly) {
  const Node& from = nodes_[node];
  const bool far = straight_distance(from.pose.point(), to.point()) > 4 * steering_.radius();
  const double bound = best_cost_ - from.g;
  std::array<Connection, kWords> all;
  const std::span<Connection> connections(all.data(), words);
  const int count = far ? steering_.connect_simply(from.pose, to, from.gear, bound, connections)
                        : steering_.connect(from.pose, to, from.gear, bound, connections);
  for (int i = 0; i < count; ++i) {
    const Connection& connection = all[static_cast<std::size_t>(i)];
    if (connection.count == 0) continue;
    if (const auto cost = drive(node, connection.all(), bound)) {
      return add(node, connection.all(), *cost, true, exactly ? &to : nullptr);
    }
  }
  return false;
}

void HybridSearch::try_goals(Index node) {
  for (const HybridGoal& goal : goals_) try_goal(node, goal);
}

/// Tries the cheapest connections to a goal.
bool HybridSearch::try_goal(Index node, const HybridGoal& goal) {
  const Pose from = nodes_[node].pose;
  std::array<double, 4> headings{goal.pose.heading};
  const int choices = goal.any_heading ? steering_.arrivals(from, goal.pose.point(), headings) : 1;
  bool reached = false;
  for (int i = 0; i < choices; ++i) {
    const Pose to{goal.pose.x, goal.pose.y, headings[static_cast<std::size_t>(i)]};
    std::array<Connection, kWords> words;
    const double bound = best_cost_ - nodes_[node].g;
    const int count = steering_.connect(from, to, nodes_[node].gear, bound, words);
    for (int k = 0; k < count; ++k) {
      const Connection& word = words[static_cast<std::size_t>(k)];
      const double limit = best_cost_ - nodes_[node].g;
      const auto cost = drive(node, word.all(), limit);
      if (!cost) continue;
      Node end = nodes_[node];
      end.pose = to;
      end.g += *cost;
      end.h = 0;
      keep(end, node, word.all());
      offer_goal(static_cast<Index>(nodes_.size() - 1), goal);
      reached = true;
      break;
    }
  }
  return reached;
}

void HybridSearch::offer_goal(Index node, const HybridGoal& goal) {
  if (nodes_[node].g >= best_cost_) return;
  if (best_ == kNone) expanded_at_first_path_ = metrics_.expanded;
  best_ = node;
  best_cost_ = nodes_[node].g;
  best_goal_ = goal.index;
}

void HybridSearch::write_path(DrivenMotions& path) const {
  path.clear();
  for (Index i = best_; nodes_[i].parent != kNone; i = nodes_[i].parent) {
    const Node& node = nodes_[i];
    const std::size_t first = path.size();
    Pose pose = nodes_[node.parent].pose;
    for (std::size_t k = 0; k < node.motion_count; ++k) {
      const Motion& motion = motions_[node.first_motion + k];
      const Pose next = pose_after(pose, motion);
      if (direction_ == Direction::from_start) {
        path.push_back({pose, motion});
      } else {
        path.push_back({facing_back(next), {motion.length, -motion.turn, motion.course}});
      }
      pose = next;
    }
    std::reverse(path.begin() + static_cast<std::ptrdiff_t>(first), path.end());
  }
  if (direction_ == Direction::from_start) std::ranges::reverse(path);
}

/// What the robot drives from the parent of a node to it, or from the node to its parent if the search begins at the
/// goal.
void HybridSearch::write_way(const Node& node) {
  way_.clear();
  Pose pose = node.parent == kNone ? node.pose : nodes_[node.parent].pose;
  way_.push_back(pose);
  for (std::size_t i = 0; node.parent != kNone && i < node.motion_count; ++i) {
    const Motion& motion = motions_[node.first_motion + i];
    // The segment between two poses turns the shorter way.
    const int parts = 1 + static_cast<int>(std::abs(motion.turn) / (kPi / 2));
    for (int part = 1; part <= parts; ++part) {
      way_.push_back(pose_after(pose, part_of(motion, static_cast<double>(part) / parts)));
    }
    pose = pose_after(pose, motion);
  }
  if (direction_ == Direction::from_start) return;
  for (Pose& at : way_) at = facing_back(at);
}

void HybridSearch::tell(const Node& node, bool expanded) {
  if (observer_ == nullptr) return;
  write_way(node);
  SearchEvent event{cell_at(node.pose.point()), {}, node.g, node.h, f_of(node),
                    way_.back().heading,        {}, way_};
  if (node.parent != kNone) {
    event.parent = cell_at(way_.front().point());
    event.parent_heading = way_.front().heading;
  }
  if (expanded) {
    observer_->on_expand(event);
  } else {
    observer_->on_generate(event);
  }
}

}  // namespace wend
