#include "wend/session/explainer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "wend/base/parse.hpp"
#include "wend/planner/failure_causes.hpp"
#include "wend/robot/nearest_passable.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/robot/zone_name.hpp"
#include "wend/session/closest_place.hpp"
#include "wend/session/failure_wording.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/way_out.hpp"

namespace wend {
namespace {

constexpr double kTypedRounding = 1e-9;  // of lengths that were typed

/// Limits of a search for what would help.
Limits limits_of_a_trial(const Deadline& deadline) {
  constexpr std::uint64_t kExpansions = 20'000;
  Limits limits = deadline.left();
  limits.expansions = kExpansions;
  return limits;
}

/// The goal that a cause is about, if any.
EndIndex goal_of(const FailureCause& cause) {
  if (const auto* const separated = std::get_if<Separated>(&cause)) return separated->goal;
  if (const auto* const blocked = std::get_if<EndBlocked>(&cause)) return blocked->end;
  return std::nullopt;
}

/// Of several goals that a path cannot reach, the cause of the one nearest to the start; null if all are off the map.
const FailureCause* nearest_cause(const Failure& failure) {
  const FailureCause* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const FailureCause& cause : failure.causes) {
    const EndIndex goal = goal_of(cause);
    if (!goal) continue;
    const double away = distance(failure.goals[*goal].place, failure.start.place);
    if (away < least) {
      least = away;
      nearest = &cause;
    }
  }
  return nearest;
}

}  // namespace

std::string Explainer::words(const Failure& failure, const SearchMetrics& metrics) const {
  return FailureText(space_, units_, hints_).of(failure, ends_of(failure, units_), metrics);
}

std::string Explainer::explain(const Failure& failure, const Ends& ends,
                               const SearchMetrics& metrics) const {
  return with_help(failure, ends, metrics, [&](const FailureCause& cause) {
    return helped(cause, failure, ends, metrics);
  });
}

/// Of several goals, what would help to the nearest one.
template <class Helped>
std::string Explainer::with_help(const Failure& failure, const Ends& ends,
                                 const SearchMetrics& metrics, Helped&& helped) const {
  const FailureText text(space_, units_, hints_);
  if (failure.causes.size() == 1) return helped(failure.causes.front()) + text.tolerance(failure);
  std::string words = text.of(failure, ends, metrics);
  if (const FailureCause* const nearest = nearest_cause(failure)) {
    words += ". The nearest of them: " + helped(*nearest);
  }
  return words;
}

/// For a planner on cells.
std::string Explainer::helped(const FailureCause& cause, const Failure& failure, const Ends& ends,
                              const SearchMetrics& metrics) const {
  if (const auto* const separated = std::get_if<Separated>(&cause)) {
    Place goal = ends.goals[separated->goal];
    // The point itself may be blocked. Another cell within the tolerance is not.
    if (failure.tolerance > 0 && !space_.passable(goal.cell)) {
      if (const auto cell = nearest_passable(space_, goal.cell)) goal = units_.place("goal", *cell);
    }
    return unreachable(ends.start, goal);
  }
  std::string words = FailureText(space_, units_, hints_).of(cause, failure, ends, metrics);
  if (const auto* const blocked = std::get_if<EndBlocked>(&cause)) {
    const Place& place = ends.at(blocked->end);
    const Place& other = blocked->end ? ends.start : ends.goals.front();
    if (!space_.passable(other.cell)) words += ". Also, " + this->blocked(other);
    words += ". " + nearest(place, other);
  }
  return words;
}

std::string Explainer::explain(const Planner& planner, const Query& query, const Ends& ends,
                               const Failure& failure, const SearchMetrics& metrics) const {
  const std::string out =
      (failure.status == Status::start_blocked ? ways_out(planner, query) : std::string()) +
      nearest_beyond_limit(planner, query, failure.status);
  if (failure.headings) return explain_pose(failure, planner, query, ends, metrics) + out;
  return explain(failure, ends, metrics) + out;
}

/// Ends off the map are named as they were asked for.
std::string Explainer::explain_pose(const Failure& failure, const Planner& planner,
                                    const Query& query, const Ends& asked,
                                    const SearchMetrics& metrics) const {
  Ends ends = ends_of(failure, units_);
  for (const FailureCause& cause : failure.causes) {
    const auto* const outside = std::get_if<EndOutside>(&cause);
    if (outside == nullptr) continue;
    (outside->end ? ends.goals[*outside->end] : ends.start) = asked.at(outside->end);
  }
  return with_help(failure, ends, metrics, [&](const FailureCause& cause) {
    std::string words = FailureText(space_, units_, hints_).of(cause, failure, ends, metrics);
    if (const auto* const blocked = std::get_if<EndBlocked>(&cause)) {
      words += nearest_place(planner, blocked->end ? query.goals[*blocked->end] : Goal(query.start),
                             !blocked->end);
    }
    if (failure.status == Status::unreachable) words += opened_by_unknown(planner, query);
    return words;
  });
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
  const std::string lets = with_value(hints_.escape, hint_of_length(way->length)) +
                           " lets the robot leave it, by a way of " + units_.length(way->length);
  if (allowed == 0) return "; " + lets;
  return ". The way out is longer than the " + units_.length(allowed) + " allowed: " + lets;
}

/// What moving ends does not do because of its limit. Of blocked ends the sentence about the nearest place says it.
std::string Explainer::nearest_beyond_limit(const Planner& planner, const Query& query,
                                            Status status) const {
  const bool asked = leeway_ && leeway_->nearest && status == Status::unreachable;
  if (!asked || !planner.grid_moves() || deadline_.passed()) return {};
  const double anywhere = std::numeric_limits<double>::infinity();
  const auto closest = closest_cells(planner, query, anywhere, deadline_);
  if (!closest || closest->distance <= most_moved() + kTypedRounding) return {};
  return ". The nearest place that a path reaches is " + units_.text(closest->goals.front().point) +
         ", " + units_.length(closest->distance) + " away" + too_far(closest->distance);
}

/// ": --nearest plans from that cell", or why it does not.
std::string Explainer::planned_from(double away, bool is_start, std::string_view place) const {
  const bool is_far = away > most_moved() + kTypedRounding;
  if (leeway_ && leeway_->nearest && is_far) return too_far(away);
  if (hints_.nearest.empty() || (is_far && hints_.nearest_limit.empty())) return {};
  const std::string limit =
      is_far ? ' ' + with_value(hints_.nearest_limit, hint_of_length(away)) : std::string();
  return ": " + hints_.nearest + limit + " plans " + (is_start ? "from" : "to") + " that " +
         std::string(place);
}

/// Of a planner with headings: the nearest place at which the robot fits.
std::string Explainer::nearest_place(const Planner& planner, const Goal& end, bool is_start) const {
  if (deadline_.passed()) return {};
  const auto free = planner.nearest_free(end);
  if (!free) {
    return ". The map has no free place for this robot" +
           std::string(end.heading ? " with that heading" : "");
  }
  const double away = distance(*free, end.point);
  return ". The nearest free place is " + units_.text(*free) + ", " + units_.length(away) +
         " away" + planned_from(away, is_start, "place");
}

/// Is there a path if unknown cells are free? Tried with the same planner.
std::string Explainer::opened_by_unknown(const Planner& planner, const Query& query) const {
  FreeSpaceOptions options = space_.options();
  if (hints_.unknown_free.empty() || options.unknown == UnknownPolicy::free ||
      space_.map().unknown().count() == 0 || deadline_.passed()) {
    return {};
  }
  options.unknown = UnknownPolicy::free;
  auto opened = make_free_space(space_.map(), options);
  const auto trial = planner.clone();
  if (!opened || !trial || !trial->update(*std::move(opened))) return {};
  const Query tried{query.start, query.goals, limits_of_a_trial(deadline_)};
  Plan plan;
  if (trial->plan(tried, plan) != Status::found) return {};
  return ". A path exists with unknown cells free" + in_brackets(hints_.unknown_free);
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

std::string Explainer::outside(const Place& place) const {
  return FailureText(space_, units_, hints_).outside(place, false);
}

std::string Explainer::blocked(const Place& place) const {
  const auto cause = why_blocked(space_, {}, place.cell);
  if (!cause) return {};
  return FailureText(space_, units_, hints_).of(*cause, Failure{}, Ends{place, {}}, {});
}

std::string Explainer::planned_as_disc(const Planner& planner) const {
  const bool by_disc = planner.grid_moves().has_value() || planner.place_grid().on_corners();
  if (space_.outline() == nullptr || !by_disc) return {};
  return "planned as the disc around its base point that covers its footprint, radius " +
         units_.length(space_.radius_in_cells()) +
         "; hybrid_astar and lattice plan with the footprint itself";
}

std::string Explainer::nearest(const Place& place, const Place& other) const {
  const auto cell = nearest_free(space_, place.cell, other.cell, moves_.adjacency());
  if (!cell) return "The map has no free cell for this robot";
  const double away = distance(centre_of(*cell), centre_of(place.cell));
  std::string text = "The nearest free cell";
  if (space_.passable(other.cell)) text += " that is connected to the " + other.name;
  text += " is " + units_.text(*cell) + ", " + units_.length(away) + " away";
  return text + planned_from(away, place.name == "start", "cell");
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
    notes.push_back(words(planner.failure(asked, why)) + "; planning " +
                    (is_start ? "from " : "to ") + units_.text(point) + ", " +
                    units_.length(distance(point, end.point)) + " away");
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
  std::string reason = words(why.failure);
  const auto helps = changes(why);
  if (helps.empty()) return reason;
  return reason + ". A drive exists with " + joined_texts(helps, "; or ");
}

std::string Explainer::width(const WidestPath& widest) const {
  if (std::isinf(widest.radius)) return "of any size: no obstacle is in the way";
  return "with a radius of up to " + units_.length(widest.radius) + ", narrowest at " +
         units_.text(widest.narrowest);
}

std::string Explainer::stopped(Status status, const Limits& limits,
                               const SearchMetrics& metrics) const {
  return FailureText(space_, units_, hints_)
      .stopped(status, {limits.expansions, limits.seconds}, metrics);
}

}  // namespace wend
