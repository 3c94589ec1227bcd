#include "wend/session/eased_query.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/path/exact_ends.hpp"
#include "wend/session/closest_place.hpp"

namespace wend {
namespace {

bool has_no_path_to_goals(Status status) {
  return status == Status::goal_outside || status == Status::goal_blocked ||
         status == Status::unreachable;
}

/// A planner's own limit ended the search, not one of the query.
bool gave_up(Status status, const Limits& limits) {
  const Limits none;
  return (status == Status::time_limit && limits.seconds == none.seconds) ||
         (status == Status::expansion_limit && limits.expansions == none.expansions);
}

Point first_of(const Path& path) {
  return path.visit([](std::span<const Cell> cells) { return centre_of(cells.front()); },
                    [](std::span<const Point> points) { return points.front(); },
                    [](const JoinedPoses& drive) { return drive.poses().front().point(); });
}

Point last_of(const Path& path) {
  return path.visit([](std::span<const Cell> cells) { return centre_of(cells.back()); },
                    [](std::span<const Point> points) { return points.back(); },
                    [](const JoinedPoses& drive) { return drive.poses().back().point(); });
}

/// Where a map has no metres, the ends of a planner on cells are cells.
bool names_cells(const Planner& planner, const Frame& frame) {
  return planner.grid_moves() && !frame.metric;
}

Point middle_under(Point point) {
  constexpr double kMost = 1e9;  // beyond it there is no cell
  const bool fits = std::abs(point.x) < kMost && std::abs(point.y) < kMost;
  return fits ? centre_of(cell_at(point)) : point;
}

}  // namespace

Ends ends_of(const Query& query, const Units& units) {
  Ends ends{units.place("start", query.start.point()), {}};
  for (const Goal& goal : query.goals) ends.goals.push_back(units.place("goal", goal.point));
  return ends;
}

EasedQuery::EasedQuery(Query query, Planner& planner, const Explainer& explainer,
                       const Units& units, const Leeway& leeway)
    : query_(std::move(query)),
      planner_(planner),
      explainer_(explainer),
      units_(units),
      leeway_(leeway),
      asked_start_(query_.start),
      asked_goals_(query_.goals) {
  if (names_cells(planner_, units_.frame())) {
    const Point start = middle_under(asked_start_.point());
    asked_start_ = {start.x, start.y, asked_start_.heading};
    for (Goal& goal : asked_goals_) goal.point = middle_under(goal.point);
    query_.start = asked_start_;
    for (Goal& goal : query_.goals) {
      if (goal.tolerance == 0) goal.point = middle_under(goal.point);
    }
  }
  if (leeway_.escape > 0) lead_start_out();
  if (leeway_.nearest) move_ends();
  if (leeway_.closest) remaining_ = 0;
}

Ends EasedQuery::ends(const EndTexts& typed) const {
  Ends ends = ends_of(query_, units_);
  if (!typed.start.empty() && query_.start == asked_start_) ends.start.text = typed.start;
  const std::size_t known = std::min(typed.goals.size(), asked_goals_.size());
  for (std::size_t i = 0; i < std::min(known, ends.goals.size()); ++i) {
    if (query_.goals[i].point == asked_goals_[i].point) ends.goals[i].text = typed.goals[i];
  }
  return ends;
}

/// "the start (3,4) is blocked: the cell is an obstacle"
std::string EasedQuery::why_blocked(const Query& query) const {
  return explainer_.words(planner_.failure(query, Status::start_blocked));
}

void EasedQuery::lead_start_out() {
  if (query_.goals.empty() || !is_blocked_start(planner_, query_.start)) return;
  const Frame& frame = units_.frame();
  auto way = way_out(planner_, query_.start, leeway_.escape_in_cells(frame));
  if (!way) return;
  lead_ = std::move(way->path);
  lead_out_ = LeadOut{way->length * frame.resolution, lead_.size() - 1, why_blocked(query_)};
  const Pose heading = lead_.driven() ? lead_.driven_poses().back()
                                      : pose_at(lead_.cells().back(), query_.start.heading);
  notes_.push_back(lead_out_->reason + "; the path begins with a way out of " +
                   units_.length(way->length) + ", to " + units_.text(heading.point()));
  query_.start = heading;
}

void EasedQuery::move_ends() {
  std::vector<std::string> notes;
  if (planner_.grid_moves()) {
    Ends ends = ends_of(query_, units_);
    const Ends asked = ends;
    notes = explainer_.move_to_nearest(ends);
    if (ends.start.cell != asked.start.cell) query_.start = pose_at(ends.start.cell);
    for (std::size_t i = 0; i < ends.goals.size(); ++i) {
      const Cell cell = ends.goals[i].cell;
      if (cell != asked.goals[i].cell) query_.goals[i].point = centre_of(cell);
    }
  } else {
    notes = explainer_.move_to_nearest(query_, planner_);
  }
  notes_.insert(notes_.end(), notes.begin(), notes.end());
}

bool EasedQuery::may_ease_goals() const {
  if (!(leeway_.closest || leeway_.nearest) || goals_eased_) return false;
  const auto moves = planner_.grid_moves();
  const FreeSpace& space = planner_.free_space();
  const auto start = cell_under(space, query_.start.point());
  if (!moves || !start || !space.passable(*start)) return true;
  return std::ranges::none_of(query_.goals, [&](const Goal& goal) {
    const auto cell = cell_under(space, goal.point);
    return cell && space.components().connected(*start, *cell, moves->adjacency());
  });
}

bool EasedQuery::ease_goals(Status status) {
  const bool wanted = leeway_.closest || leeway_.nearest;
  if (!wanted || goals_eased_ || (status == Status::goal_outside && !leeway_.closest)) return false;
  if (!has_no_path_to_goals(status) && !gave_up(status, query_.limits)) return false;
  const double most = leeway_.closest ? std::numeric_limits<double>::infinity()
                                      : leeway_.nearest_in_cells(units_.frame());
  Query asked = query_;
  asked.goals = asked_goals_;
  auto places = closest_places(planner_, asked, most, explainer_.deadline());
  if (!places) return false;
  query_.goals = std::move(places->goals);
  goals_eased_ = true;
  return true;
}

/// The goal that is nearest to the end of a path, of those in its cell; the end itself if it reaches a goal or there is
/// none.
Point EasedQuery::goal_in_cell(Point end) const {
  std::optional<Point> nearest;
  for (const Goal& goal : asked_goals_) {
    if (goal.reaches(end)) return end;
    if (cell_under(planner_.free_space(), goal.point) != cell_at(end)) continue;
    if (!nearest || distance(goal.point, end) < distance(*nearest, end)) nearest = goal.point;
  }
  return nearest.value_or(end);
}

/// Where the start or a goal lies in the path's first or last cell, and the robot can go from there, the path begins or
/// ends there.
void EasedQuery::end_exactly(Plan& plan) const {
  const auto moves = planner_.grid_moves();
  if (!moves) return;
  PathEnds ends{first_of(plan.path), last_of(plan.path)};
  const bool begins = lead_.empty() && cell_under(planner_.free_space(), asked_start_.point()) ==
                                           cell_at(ends.start);
  if (begins) ends.start = asked_start_.point();
  ends.goal = goal_in_cell(ends.goal);
  plan.path = with_ends(plan.path, ends, planner_.free_space(), moves->adjacency());
}

void EasedQuery::finish(Plan& plan) {
  if (lead_out_) {
    const Pose first = lead_.poses().front();
    if (lead_.driven()) {
      plan.start_snapping_error = {
          distance(first.point(), asked_start_.point()),
          std::abs(normalized_angle(first.heading - asked_start_.heading))};
    }
  }
  if (!plan.path.driven()) {
    end_exactly(plan);
    const Point first = lead_.empty() ? first_of(plan.path) : first_of(lead_);
    constexpr double kRounding = 1e-6;  // cells
    const auto error = [](double apart) { return SnappingError{apart > kRounding ? apart : 0, 0}; };
    plan.start_snapping_error = error(distance(first, asked_start_.point()));
    plan.goal_snapping_error = error(distance_to_goals(last_of(plan.path), asked_goals_));
  }
  if (!goals_eased_) return;
  const Point end = plan.path.points().back();
  remaining_ = distance_to_goals(end, asked_goals_);
  notes_.push_back("no path reaches " +
                   (asked_goals_.size() == 1
                        ? "the goal " + units_.text(asked_goals_.front().point)
                        : "any of the " + std::to_string(asked_goals_.size()) + " goals") +
                   "; planning to the closest reachable place " + units_.text(end) + ", " +
                   units_.length(*remaining_) + " away");
}

void begin_with(const Path& lead, Plan& plan, const Frame& frame) {
  if (lead.empty()) return;
  if (lead.driven() && !plan.moves.empty()) {
    const auto poses = lead.driven_poses();
    std::vector<std::string_view> names;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      names.push_back(name_of(segment_between(poses[i - 1], poses[i]), frame));
    }
    plan.moves.insert(plan.moves.begin(), names.begin(), names.end());
  }
  plan.path = joined(lead, plan.path);
}

}  // namespace wend
