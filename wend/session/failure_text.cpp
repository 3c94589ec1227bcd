#include "wend/session/failure_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "wend/base/parse.hpp"
#include "wend/robot/zone_name.hpp"
#include "wend/session/failure_wording.hpp"

namespace wend {
namespace {

std::string rounded(double value) { return format_number(std::round(value * 1e4) / 1e4); }

/// "1 step", "2 steps"
std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
}

/// "the goal (3,4)", or "any of the 2 goals"
std::string goals_text(const Ends& ends) {
  const std::size_t count = ends.goals.size();
  return count == 1 ? "the goal " + ends.goals.front().text
                    : "any of the " + std::to_string(count) + " goals";
}

bool is_outside(const Failure& failure, EndIndex end) {
  return std::ranges::any_of(failure.causes, [end](const FailureCause& cause) {
    const auto* const outside = std::get_if<EndOutside>(&cause);
    return outside != nullptr && outside->end == end;
  });
}

std::string named(const Place& place) { return "the " + place.name + ' ' + place.text; }

Place place_of(EndIndex index, const Failure& failure, const Units& units) {
  const QueryEnd& end = failure.at(index);
  Place place = units.place(index ? "goal" : "start", end.asked);
  if (!failure.headings || is_outside(failure, index)) return place;
  Frame frame = units.frame();
  frame.metric = units.metric();
  place.text = pose_text(end.place, end.heading, frame);
  constexpr double kSame = 1e-6;  // cells
  if (distance(end.asked, end.place) > kSame) {
    const std::string asked = pose_text(end.asked, end.heading, frame);
    if (asked != place.text) place.text += ", the nearest place to " + asked + ',';
  }
  return place;
}

}  // namespace

std::string with_value(const std::string& hint, const std::string& value) {
  return hint + (hint.ends_with('=') ? "" : " ") + value;
}

std::string in_brackets(const std::string& hint, const std::string& value) {
  if (hint.empty()) return {};
  return " (" + (value.empty() ? hint : with_value(hint, value)) + ')';
}

std::string joined_texts(const std::vector<std::string>& texts, std::string_view separator) {
  std::string all;
  for (const std::string& text : texts) {
    if (!all.empty()) all += separator;
    all += text;
  }
  return all;
}

Ends ends_of(const Failure& failure, const Units& units) {
  Ends ends{place_of({}, failure, units), {}};
  for (std::size_t i = 0; i < failure.goals.size(); ++i) {
    ends.goals.push_back(place_of(i, failure, units));
  }
  return ends;
}

std::string FailureText::of(const Failure& failure, const Ends& ends,
                            const SearchMetrics& metrics) const {
  if (failure.causes.empty()) return std::string(describe(failure.status));
  if (failure.causes.size() == 1) {
    return of(failure.causes.front(), failure, ends, metrics) + tolerance(failure);
  }
  std::vector<std::string> texts;
  for (const FailureCause& cause : failure.causes) {
    const auto* const separated = std::get_if<Separated>(&cause);
    texts.push_back(separated != nullptr
                        ? "there is no path to " + named(ends.goals[separated->goal])
                        : of(cause, failure, ends, metrics));
  }
  return "none of " + std::to_string(texts.size()) +
         " goals can be reached: " + joined_texts(texts, "; ") + tolerance(failure);
}

std::string FailureText::of(const FailureCause& cause, const Failure& failure, const Ends& ends,
                            const SearchMetrics& metrics) const {
  return std::visit(
      [&]<class Cause>(const Cause& what) -> std::string {
        if constexpr (std::is_same_v<Cause, EndOutside>) {
          return outside(ends.at(what.end), failure.places.on_corners());
        } else if constexpr (std::is_same_v<Cause, EndBlocked>) {
          return of(what, failure, ends);
        } else if constexpr (std::is_same_v<Cause, Separated>) {
          return "there is no path from start " + ends.start.text + " to goal " +
                 ends.goals[what.goal].text +
                 (failure.headings ? ": no sequence of motion primitives leads there" : "");
        } else if constexpr (std::is_same_v<Cause, NoMotion>) {
          return "no motion primitive " + std::string(what.end ? "reaches " : "leaves ") +
                 named(ends.at(what.end));
        } else if constexpr (std::is_same_v<Cause, NoDriveFound>) {
          return of(what, ends);
        } else if constexpr (std::is_same_v<Cause, OwnLimit>) {
          return "no drive from " + named(ends.start) + " to " + goals_text(ends) +
                 " was found within " + format_number(what.value) + " s of CPU time, the " +
                 what.option + " of " + what.planner +
                 ": there may be one; a larger budget searches longer";
        } else if constexpr (std::is_same_v<Cause, Stopped>) {
          return stopped(failure.status, what, metrics);
        } else if constexpr (std::is_same_v<Cause, OwnText>) {
          return what.text.empty() ? std::string(describe(failure.status)) : what.text;
        } else {
          return of(what);
        }
      },
      cause);
}

std::string FailureText::outside(const Place& place, bool on_corners) const {
  return named(place) + " is outside the map, which covers " +
         (on_corners ? units_.extent_of_corners() : units_.extent());
}

std::string FailureText::of(const EndBlocked& blocked, const Failure& failure,
                            const Ends& ends) const {
  const std::string text = named(ends.at(blocked.end)) + " is blocked";
  if (!blocked.at_every_heading) return text + ": " + why(blocked, failure);
  return text + " at every heading that was tried; at " + heading_text(0, units_.frame()) + ": " +
         why(blocked, failure);
}

std::string FailureText::why(const EndBlocked& blocked, const Failure& failure) const {
  switch (blocked.reason) {
    case BlockReason::obstacle:
      return cell_of(blocked, failure) +
             (blocked.mask ? " is blocked by " + mask_text(*blocked.mask) : " is an obstacle");
    case BlockReason::unknown:
      return cell_of(blocked, failure) + " is unknown" +
             (hints_.unknown_free.empty()
                  ? ""
                  : " (" + hints_.unknown_free + " makes unknown cells free)");
    case BlockReason::too_close:
      return too_near(blocked, failure, "the nearest obstacle") +
             (blocked.mask ? ": it is " + mask_text(*blocked.mask) : "");
    case BlockReason::over_edge:
      return "the robot would extend beyond the map: " + too_near(blocked, failure, "the edge") +
             (hints_.outside_free.empty() || !blocked.fits_beyond_edge
                  ? ""
                  : " (" + hints_.outside_free + " allows it)");
    case BlockReason::outside:
    case BlockReason::overlaps:
    case BlockReason::leaves:
      if (blocked.contact) return describe(*blocked.contact, space_);
  }
  return "it is " + std::string(describe(blocked.reason));
}

/// A planner on cells has named the cell; the robot of another stands in it, or, on a vertex, beside it.
std::string FailureText::cell_of(const EndBlocked& blocked, const Failure& failure) const {
  if (!failure.headings || !blocked.cell) return "the cell";
  const std::string cell = "cell " + cell_text(*blocked.cell);
  return failure.places.on_corners() ? cell + " next to it" : cell;
}

/// Planners on cells know no headings and take a polygon for the disc around it.
std::string FailureText::too_near(const EndBlocked& blocked, const Failure& failure,
                                  std::string_view obstacle) const {
  const std::string_view radius = space_.outline()
                                      ? "the radius of the disc around the robot's footprint"
                                      : "the robot's radius";
  const bool from_middle =
      failure.headings && blocked.cell && failure.at(blocked.end).place != centre_of(*blocked.cell);
  return std::string(obstacle) + " is " + units_.length(blocked.distance) +
         (from_middle ? " from the middle of cell " + cell_text(*blocked.cell) : " away") + ", " +
         std::string(radius) + " is " + units_.length(blocked.radius);
}

/// "6 x 3 cells" or "0.6 x 0.3 m"
std::string FailureText::size(double width, double height) const {
  const double unit = units_.metric() ? units_.frame().resolution : 1;
  return rounded(width * unit) + " x " + rounded(height * unit) +
         (units_.metric() ? " m" : " cells");
}

std::string FailureText::of(const RobotTooLarge& robot) const {
  const std::string what =
      space_.outline() != nullptr
          ? "the robot's footprint, " + size(robot.width, robot.height) + ','
          : "the robot, a disc with a radius of " + units_.length(robot.width / 2) + ',';
  return what + " is larger than the map, " + size(space_.width(), space_.height());
}

std::string FailureText::of(const NoDriveFound& why, const Ends& ends) const {
  const std::string start = named(ends.start);
  const std::string goal = goals_text(ends);
  switch (why.why) {
    case NoDriveFound::Why::parted: {
      std::string text = "there is no path from start " + ends.start.text + " to " +
                         (ends.goals.size() == 1 ? "goal " + ends.goals.front().text : goal) +
                         ": obstacles separate the two";
      if (why.disc_radius == 0) return text;
      return text + ", even for " +
             (space_.footprint().covers_base_point() ? "the largest disc within the robot"
                                                     : "a disc within the robot") +
             ", with a radius of " + units_.length(why.disc_radius);
    }
    case NoDriveFound::Why::goal_boxed_in:
      return (ends.goals.size() == 1
                  ? goal
                  : "each of the " + std::to_string(ends.goals.size()) + " goals") +
             " is boxed in: the robot cannot get there, however it moves";
    case NoDriveFound::Why::start_boxed_in:
      return start + " is boxed in: the robot cannot get from there to " + goal +
             ", however it moves";
    case NoDriveFound::Why::none_found:
      break;
  }
  return "no drive from " + start + " to " + goal + " was found at this resolution, in boxes of " +
         units_.length(why.box) + ", " + std::to_string(why.headings) +
         " headings and motions of " + units_.length(why.step) +
         (why.lattice_searched
              ? "; a search on a lattice of half cells and 16 headings found none either"
              : "") +
         "; there may be one all the same";
}

std::string FailureText::of(const InvalidQuery& invalid) const {
  const std::string heading =
      "the heading of the " + std::string(invalid.end ? "goal" : "start") + " is not a ";
  switch (invalid.fault) {
    case InvalidQuery::Fault::no_goal:
      return "the query has no goal";
    case InvalidQuery::Fault::tolerance:
      return "the tolerances of a goal must be at least 0";
    case InvalidQuery::Fault::seconds:
      return "the limit of seconds is NaN";
    case InvalidQuery::Fault::heading:
      return heading + "finite number";
    case InvalidQuery::Fault::large_heading:
      return heading + "number of radians in -1e6..1e6";
  }
  return {};
}

std::string FailureText::stopped(Status status, const Stopped& limits,
                                 const SearchMetrics& metrics) const {
  const std::string expansions = counted(metrics.expanded, "expansion");
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
      return "the walk ended after " + counted(metrics.expanded - 1, "step") +
             in_brackets(hints_.limit_steps);
    default:
      return std::string(describe(status));
  }
}

std::string FailureText::tolerance(const Failure& failure) const {
  if (!(failure.tolerance > 0)) return {};
  const std::string within = " within its tolerance of " + units_.length(failure.tolerance);
  switch (failure.status) {
    case Status::goal_outside:
      return ". Its tolerance of " + units_.length(failure.tolerance) + " does not reach the map";
    case Status::goal_blocked:
      return ". The robot fits nowhere" + within;
    case Status::unreachable:
      return ". No place" + within + " can be reached";
    default:
      return {};
  }
}

std::string words_of(const Failure& failure, const SearchMetrics& metrics, const FreeSpace& space,
                     const Hints& hints) {
  const Units units(space.map());
  return FailureText(space, units, hints).of(failure, ends_of(failure, units), metrics);
}

std::string words_of(const PlanFailure& failure, const FreeSpace& space, const Hints& hints) {
  if (failure.failure.status == Status::found) return failure.message;
  return words_of(failure.failure, failure.metrics, space, hints);
}

}  // namespace wend
