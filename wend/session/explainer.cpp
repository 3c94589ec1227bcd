#include "wend/session/explainer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/base/parse.hpp"
#include "wend/geometry/arc_distance.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/robot/nearest_passable.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/robot/zone_name.hpp"
#include "wend/session/closest_place.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/way_out.hpp"

namespace wend {
namespace {

constexpr double kTypedRounding = 1e-9;  // of lengths that were typed

bool is_about_a_goal(Status status) {
  return status == Status::goal_outside || status == Status::goal_blocked ||
         status == Status::unreachable;
}

/// " (--unknown free)"; empty for an empty hint.
std::string in_brackets(const std::string& hint, const std::string& value = {}) {
  if (hint.empty()) return {};
  return " (" + hint + (value.empty() ? "" : " " + value) + ')';
}

std::string joined_texts(const std::vector<std::string>& texts, std::string_view separator) {
  std::string all;
  for (const std::string& text : texts) {
    if (!all.empty()) all += separator;
    all += text;
  }
  return all;
}

/// ": it is the keep-out mask 'zones.yaml'", if no obstacle is too near for the robot's disc, but a zone is.
std::string mask_near(const FreeSpace& space, Cell cell) {
  const Point centre = centre_of(cell);
  std::optional<std::string> mask;
  const auto is_obstacle = [&](Cell square) {
    const double away = distance(centre, square);
    if (space.far_enough(4 * away * away)) return false;
    const auto name = mask_that_blocks(space, square);
    if (name) mask = name;
    return !name;
  };
  const Box near = Box(centre).grown_by(space.radius_in_cells());
  if (any_obstacle(space, near, is_obstacle) || !mask) return {};
  return ": it is " + *mask;
}

}  // namespace

std::string Explainer::explain(Status status, const Ends& ends, const Limits& limits,
                               const SearchMetrics& metrics) const {
  if (ends.goals.size() > 1 && is_about_a_goal(status)) return explain_goals(ends);
  const Place& goal = ends.goals.front();
  switch (status) {
    case Status::start_outside:
      return outside(ends.start);
    case Status::goal_outside:
      return outside(goal);
    case Status::start_blocked:
      return blocked_end(ends.start, goal);
    case Status::goal_blocked:
      return blocked_end(goal, ends.start);
    case Status::unreachable:
      return unreachable(ends.start, goal);
    default:
      return stopped(status, limits, metrics);
  }
}

std::string Explainer::explain(const Query& query, const Ends& ends, Status status,
                               const SearchMetrics& metrics) const {
  const double tolerance = query.goals.front().tolerance;
  Ends reachable = ends;
  if (status == Status::unreachable && tolerance > 0) {
    // The point itself may be blocked. Another cell within the tolerance is not.
    for (Place& goal : reachable.goals) {
      const auto cell = nearest_passable(space_, goal.cell);
      if (cell && *cell != goal.cell) goal = units_.place(goal.name, *cell);
    }
  }
  return explain(status, reachable, query.limits, metrics) +
         beyond_tolerance(query, status, units_.length(tolerance));
}

std::string Explainer::explain(const Planner& planner, const Query& query, const Ends& ends,
                               Status status, const SearchMetrics& metrics) const {
  if (status == Status::index_mismatch) return planner.reason(query, status);
  const std::string out =
      (status == Status::start_blocked ? ways_out(planner, query) : std::string()) +
      nearest_beyond_limit(planner, query, status);
  if (planner.grid_moves()) return explain(query, ends, status, metrics) + out;
  if (is_limit(status)) {
    const bool of_planner = status == Status::time_limit && std::isinf(query.limits.seconds);
    const std::string own = of_planner ? planner.reason(query, status) : std::string();
    if (own.empty()) return stopped(status, query.limits, metrics);
    return as_asked(ends, planner.place_grid()) + own;
  }
  const PlaceGrid places = planner.place_grid();
  if (status == Status::start_outside || status == Status::goal_outside) {
    const Place& place = status == Status::start_outside ? ends.start : ends.goals.front();
    return "the " + place.name + ' ' + place.text + " is outside the map, which covers " +
           (places.on_corners() ? units_.extent_of_corners() : units_.extent());
  }
  return as_asked(ends, places) + planner.reason(query, status) + out;
}

/// How a robot that does not fit at the start can leave it, or why it cannot.
std::string Explainer::ways_out(const Planner& planner, const Query& query) const {
  if (hints_.escape.empty() || deadline_.passed()) return {};
  const Frame& frame = units_.frame();
  const double allowed = leeway_ ? leeway_->escape_in_cells(frame) : 0;
  constexpr double kFarCells = 40;  // a way out that is longer is none
  constexpr double kFarMetres = 2;
  const double far =
      std::max({kFarCells, 2 * allowed, frame.metric ? kFarMetres / frame.resolution : 0});
  constexpr int kFewPlaces = 200;  // a reason is not worth more
  const auto way = way_out(planner, query.start, std::min(far, 4 * kFarCells), kFewPlaces);
  if (!way && allowed == 0) return {};
  if (!way) return ". No way out of it was found along which the robot does not go deeper";
  const std::string lets = hints_.escape + ' ' + hint_of_length(way->length) +
                           " lets the robot leave it, by a way of " + units_.length(way->length);
  if (allowed == 0) return "; " + lets;
  return ". The way out is longer than the " + units_.length(allowed) + " allowed: " + lets;
}

/// What moving ends does not do because of its limit. Of blocked ends of a planner on cells the sentence about the
/// nearest free cell says it.
std::string Explainer::nearest_beyond_limit(const Planner& planner, const Query& query,
                                            Status status) const {
  if (!leeway_ || !leeway_->nearest || deadline_.passed()) return {};
  const auto beyond = [&](const std::string& what, Point place, double away) {
    if (away <= most_moved() + kTypedRounding) return std::string();
    return ". The nearest " + what + " is " + units_.text(place) + ", " + units_.length(away) +
           " away" + too_far(away);
  };
  const double anywhere = std::numeric_limits<double>::infinity();
  if (planner.grid_moves()) {
    const auto closest = status == Status::unreachable
                             ? closest_cells(planner, query, anywhere, deadline_)
                             : std::nullopt;
    if (!closest) return {};
    return beyond("place that a path reaches", closest->goals.front().point, closest->distance);
  }
  if (status != Status::start_blocked && status != Status::goal_blocked) return {};
  const Goal end = status == Status::start_blocked ? Goal(query.start) : query.goals.front();
  const auto free = planner.nearest_free(end);
  return free ? beyond("free place", *free, distance(*free, end.point)) : std::string();
}

/// A length as a front end takes it, rounded up a little.
std::string Explainer::hint_of_length(double cells) const {
  const double length = units_.metric() ? cells * units_.frame().resolution : cells;
  constexpr double kSteps = 20;  // of 0.05
  return format_number(std::ceil(length * kSteps - 1e-6) / kSteps);
}

double Explainer::most_moved() const {
  return leeway_ ? leeway_->nearest_in_cells(units_.frame())
                 : std::numeric_limits<double>::infinity();
}

/// ", more than the limit of 0.5 m (--nearest-limit 0.8)"
std::string Explainer::too_far(double away) const {
  return ", more than the limit of " + units_.length(most_moved()) +
         in_brackets(hints_.nearest_limit, hint_of_length(away));
}

/// Reasons of planners of poses name their places, in the units of the map. If these are not what was asked, that
/// comes first.
std::string Explainer::as_asked(const Ends& ends, const PlaceGrid& places) const {
  if (units_.metric() == units_.frame().metric && places.spacing == 1) return {};
  std::vector<std::string> goals;
  goals.reserve(ends.goals.size());
  for (const Place& goal : ends.goals) goals.push_back(goal.text);
  return "from " + ends.start.text + " to " + joined_texts(goals, " or ") + ": ";
}

std::string Explainer::explain_goals(const Ends& ends) const {
  std::vector<std::string> reasons;
  for (const Place& goal : ends.goals) {
    const std::string reason = blocked(goal);
    reasons.push_back(reason.empty() ? "there is no path to the goal " + goal.text : reason);
  }
  return "none of " + std::to_string(ends.goals.size()) +
         " goals can be reached: " + joined_texts(reasons, "; ");
}

std::string Explainer::outside(const Place& place) const {
  return "the " + place.name + ' ' + place.text + " is outside the map, which covers " +
         units_.extent();
}

std::string Explainer::blocked(const Place& place) const {
  const auto reason = space_.why_blocked(place.cell);
  if (!reason) return {};
  if (*reason == BlockReason::outside) return outside(place);
  return "the " + place.name + ' ' + place.text + " is blocked: " + why(place, *reason);
}

std::string Explainer::why(const Place& place, BlockReason reason) const {
  switch (reason) {
    case BlockReason::obstacle:
      if (const auto mask = mask_that_blocks(space_, place.cell)) {
        return "the cell is blocked by " + *mask;
      }
      return "the cell is an obstacle";
    case BlockReason::unknown:
      if (hints_.unknown_free.empty()) return "the cell is unknown";
      return "the cell is unknown (" + hints_.unknown_free + " makes unknown cells free)";
    case BlockReason::too_close:
      return too_near(place, "the nearest obstacle");
    case BlockReason::over_edge:
      return "the robot would extend beyond the map: " + too_near(place, "the edge") +
             (hints_.outside_free.empty() ? "" : " (" + hints_.outside_free + " allows it)");
    case BlockReason::outside:
    case BlockReason::overlaps:
    case BlockReason::leaves:
      break;
  }
  return std::string(describe(reason));
}

/// Planners on cells know no headings and take a polygon for the disc around it.
std::string Explainer::too_near(const Place& place, std::string_view obstacle) const {
  const std::string_view radius = space_.outline()
                                      ? "the radius of the disc around the robot's footprint"
                                      : "the robot's radius";
  return std::string(obstacle) + " is " + units_.length(space_.clearance(place.cell)) + " away, " +
         std::string(radius) + " is " + units_.length(space_.radius_in_cells()) +
         mask_near(space_, place.cell);
}

std::string Explainer::planned_as_disc(const Planner& planner) const {
  const bool by_disc = planner.grid_moves().has_value() || planner.place_grid().on_corners();
  if (space_.outline() == nullptr || !by_disc) return {};
  return "planned as the disc around its base point that covers its footprint, radius " +
         units_.length(space_.radius_in_cells()) +
         "; hybrid_astar and lattice plan with the footprint itself";
}

std::string Explainer::blocked_end(const Place& place, const Place& other) const {
  std::string text = blocked(place);
  if (!space_.passable(other.cell)) text += ". Also, " + blocked(other);
  return text + ". " + nearest(place, other);
}

std::string Explainer::nearest(const Place& place, const Place& other) const {
  const auto cell = nearest_free(space_, place.cell, other.cell, moves_.adjacency());
  if (!cell) return "The map has no free cell for this robot";
  const double away = distance(centre_of(*cell), centre_of(place.cell));
  std::string text = "The nearest free cell";
  if (space_.passable(other.cell)) text += " that is connected to the " + other.name;
  text += " is " + units_.text(*cell) + ", " + units_.length(away) + " away";
  if (leeway_ && leeway_->nearest && away > most_moved()) return text + too_far(away);
  if (hints_.nearest.empty()) return text;
  return text + ": " + hints_.nearest + " plans " + (place.name == "start" ? "from" : "to") +
         " that cell";
}

std::vector<std::string> Explainer::move_to_nearest(Ends& ends) const {
  std::vector<std::string> notes;
  for (Place& goal : ends.goals) {
    const NearestEnds moved = nearest_ends(space_, ends.start.cell, goal.cell, moves_.adjacency());
    const auto is_near = [&](Cell from, Cell to) {
      return from != to &&
             distance(centre_of(from), centre_of(to)) <= most_moved() + kTypedRounding;
    };
    if (is_near(ends.start.cell, moved.start)) {
      notes.push_back(move(ends.start, moved.start, "from"));
    }
    if (is_near(goal.cell, moved.goal)) notes.push_back(move(goal, moved.goal, "to"));
  }
  return notes;
}

std::vector<std::string> Explainer::move_to_nearest(Query& query, const Planner& planner) const {
  std::vector<std::string> notes;
  const auto moved = [&](const Goal& end, const Query& asked, bool is_start) {
    const Point point = planner.nearest_free(end).value_or(end.point);
    if (point == end.point || distance(point, end.point) > most_moved() + kTypedRounding) {
      return end.point;
    }
    const bool on_map = cell_under(space_, end.point).has_value();
    const Status why = is_start ? (on_map ? Status::start_blocked : Status::start_outside)
                                : (on_map ? Status::goal_blocked : Status::goal_outside);
    notes.push_back(planner.reason(asked, why) + "; planning " + (is_start ? "from " : "to ") +
                    units_.text(point) + ", " + units_.length(distance(point, end.point)) +
                    " away");
    return point;
  };
  const Point start = moved(Goal(query.start), query, true);
  for (Goal& goal : query.goals) goal.point = moved(goal, {query.start, {goal}}, false);
  query.start.x = start.x;
  query.start.y = start.y;
  return notes;
}

std::string Explainer::move(Place& place, Cell cell, std::string_view preposition) const {
  const double away = distance(centre_of(cell), centre_of(place.cell));
  std::string note = blocked(place) + "; planning " + std::string(preposition) + ' ' +
                     units_.text(cell) + ", " + units_.length(away) + " away";
  place.cell = cell;
  place.text = units_.text(cell);
  return note;
}

std::string Explainer::unreachable(const Place& start, const Place& goal) const {
  const auto known = explain_no_path(space_, start.cell, goal.cell, moves_, deadline_);
  std::string text = "there is no path from start " + start.text + " to goal " + goal.text;
  if (!known) return text + "; the limit on time left none to find out why";
  const NoPath& why = *known;
  text += ": the start's connected component has " + units_.area(why.start_component) +
          ", the goal's has " + units_.area(why.goal_component) + ". ";
  if (why.ways.empty()) return text + "Obstacles separate the two, even for a robot with radius 0";
  std::vector<std::string> changes;
  changes.reserve(why.ways.size());
  for (const Way& way : why.ways) changes.push_back(change(way));
  text += "A path exists with " + joined_texts(changes, "; or ");
  return hints_.explain.empty() ? text : text + ". " + hints_.explain;
}

std::string Explainer::change(const Way& way) const {
  std::vector<std::string> changes;
  if (way.unknown_free) changes.push_back("unknown cells free" + in_brackets(hints_.unknown_free));
  if (way.squeeze) {
    changes.push_back("moves between obstacles that touch at a corner" +
                      in_brackets(hints_.squeeze));
  }
  if (way.smaller_robot) {
    changes.push_back("a radius of at most " + units_.length(way.widest.radius) +
                      in_brackets(hints_.robot_radius, units_.radius(way.widest.radius)));
  }
  return joined_texts(changes, " and ");
}

std::vector<std::string> Explainer::changes(const NoDrive& why) const {
  std::vector<std::string> changes;
  if (why.footprint_scale) {
    const double percent = std::floor(*why.footprint_scale * 1000) / 10;
    changes.push_back("a footprint of at most " + format_number(percent) + " % of the size");
  }
  if (why.turning_radius) {
    const double cells = *why.turning_radius / units_.frame().resolution;
    changes.push_back("a turning radius of at most " + units_.length(cells) +
                      in_brackets(hints_.turning_radius, units_.radius(cells)));
  }
  if (why.reverse_helps == true) {
    changes.push_back("driving in reverse" + in_brackets(hints_.allow_reverse));
  }
  return changes;
}

std::string Explainer::explain(const NoDrive& why) const {
  if (why.drive_exists()) return "there is a drive";
  const auto helps = changes(why);
  if (helps.empty()) return why.reason;
  return why.reason + ". A drive exists with " + joined_texts(helps, "; or ");
}

std::string Explainer::width(const WidestPath& widest) const {
  if (std::isinf(widest.radius)) return "of any size: no obstacle is in the way";
  return "with a radius of up to " + units_.length(widest.radius) + ", narrowest at " +
         units_.text(widest.narrowest);
}

std::string Explainer::stopped(Status status, const Limits& limits,
                               const SearchMetrics& metrics) const {
  const std::string expansions = std::to_string(metrics.expanded) + " expansions";
  switch (status) {
    case Status::expansion_limit:
      if (limits.expansions == Limits::kUnlimited) {
        return "stopped after " + expansions + ", the planner's own limit; give it a higher one" +
               in_brackets(hints_.limit_expansions, std::to_string(2 * metrics.expanded));
      }
      return "stopped after " + expansions +
             in_brackets(hints_.limit_expansions, std::to_string(limits.expansions));
    case Status::time_limit:
      if (std::isinf(limits.seconds)) {
        return "stopped after " + expansions + ", at the planner's own limit on CPU time";
      }
      return "stopped after " + format_number(limits.seconds) + " s and " + expansions +
             in_brackets(hints_.limit_seconds, format_number(limits.seconds));
    case Status::cancelled:
      return "cancelled after " + expansions;
    case Status::step_limit:
      return "the walk ended after " + std::to_string(metrics.expanded - 1) + " steps" +
             in_brackets(hints_.limit_steps);
    default:
      return std::string(describe(status));
  }
}

bool is_limit(Status status) {
  return status == Status::expansion_limit || status == Status::time_limit ||
         status == Status::step_limit || status == Status::cancelled;
}

}  // namespace wend
