#include "wend/planner/se2/hybrid_reasons.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wend/base/parse.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/map/place_text.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/sweep/contact.hpp"
#include "wend/robot/zone_name.hpp"

namespace wend {
namespace {

std::string rounded(double value) { return format_number(std::round(value * 1e4) / 1e4); }

std::string start_of(const FreeSpace& space, const Query& query) {
  return "the start " + pose_text(query.start, space.map().frame());
}

std::string goal_of(const FreeSpace& space, const Goal& goal) {
  return "the goal " + pose_text(goal.point, goal.heading, space.map().frame());
}

std::string goals_of(const FreeSpace& space, const Query& query) {
  const std::size_t count = query.goals.size();
  return count == 1 ? goal_of(space, query.goals.front())
                    : "any of the " + std::to_string(count) + " goals";
}

/// A number of cells as metres on a map in metres.
std::string number_of(const FreeSpace& space, double cells) {
  const Frame& frame = space.map().frame();
  return rounded(frame.metric ? cells * frame.resolution : cells);
}

/// "0.25 m" or "2.5 cells"
std::string length_text(const FreeSpace& space, double cells) {
  if (space.map().frame().metric) return number_of(space, cells) + " m";
  return number_of(space, cells) + (cells == 1 ? " cell" : " cells");
}

/// "6 x 3 cells" or "0.6 x 0.3 m"
std::string size_text(const FreeSpace& space, double width, double height) {
  return number_of(space, width) + " x " + number_of(space, height) +
         (space.map().frame().metric ? " m" : " cells");
}

/// Of the box around an outline.
std::string size_text(const FreeSpace& space, const Polygon& outline) {
  Box box(outline.corners().front());
  for (const Point corner : outline.corners()) box.include(corner);
  return size_text(space, box.high.x - box.low.x, box.high.y - box.low.y);
}

double longest_distance(const Polygon& outline) {
  double most = 0;
  for (const Point a : outline.corners()) most = std::max(most, farthest_distance(outline, a));
  return most;
}

/// Of a disc within the robot, not always around its base point.
double inner_radius_in_cells(const FreeSpace& space) {
  return space.footprint().inner_disc().radius / space.map().frame().resolution;
}

/// Is the robot larger than the map, wherever it stands?
bool is_too_large(const FreeSpace& space) {
  if (space.outside() == OutsidePolicy::free) return false;
  const double narrow = std::min(space.width(), space.height());
  if (2 * inner_radius_in_cells(space) > narrow) return true;
  return space.outline() != nullptr &&
         longest_distance(*space.outline()) > hypotenuse(space.width(), space.height());
}

std::string too_large(const FreeSpace& space) {
  const std::string robot =
      space.outline() != nullptr
          ? "the robot's footprint, " + size_text(space, *space.outline()) + ','
          : "the robot, a disc with a radius of " + length_text(space, space.radius_in_cells()) +
                ',';
  return robot + " is larger than the map, " + size_text(space, space.width(), space.height());
}

std::string distance_to_nearest(const FreeSpace& space, Cell cell, std::string_view what,
                                double radius) {
  return std::string(what) + " is " + length_text(space, space.clearance(cell)) +
         " from the middle of cell " + cell_text(cell) + ", the robot's radius is " +
         length_text(space, radius);
}

std::string why_blocked(const FreeSpace& space, const Pose& pose) {
  const auto reason = space.why_blocked(pose);
  if (!reason) return {};
  const Cell cell = cell_at(pose.point());
  if (*reason == BlockReason::overlaps || *reason == BlockReason::leaves) {
    if (const auto contact = contact_at(space, pose)) return ": " + describe(*contact, space);
  }
  const double radius = space.radius_in_cells();
  switch (*reason) {
    case BlockReason::obstacle:
      if (const auto mask = mask_that_blocks(space, cell)) {
        return ": its base point lies in a cell that " + *mask + " blocks";
      }
      return ": its base point lies in an obstacle cell";
    case BlockReason::unknown:
      return ": its base point lies in an unknown cell";
    case BlockReason::too_close:
      return ": " + distance_to_nearest(space, cell, "the nearest obstacle", radius);
    case BlockReason::over_edge:
      return ": " + distance_to_nearest(space, cell, "the map's edge", radius);
    default:
      return ": " + std::string(describe(*reason));
  }
}

std::string does_not_fit(const FreeSpace& space, const std::string& place, const Pose& pose) {
  if (is_too_large(space)) return too_large(space);
  return "the robot does not fit at " + place + why_blocked(space, pose);
}

std::string outside_of(const FreeSpace& space) {
  const Frame& frame = space.map().frame();
  return " is outside the map, which covers " +
         (frame.metric ? covered_metres(frame, space.width(), space.height())
                       : "x from 0 to " + std::to_string(space.width()) + " and y from 0 to " +
                             std::to_string(space.height()));
}

std::string disc_within(const FreeSpace& space) {
  return space.footprint().covers_base_point() ? "the largest disc within the robot"
                                               : "a disc within the robot";
}

/// What has been searched without a drive.
std::string searched_text(const FreeSpace& space, const NoDriveFound& no_drive) {
  const HybridResolution& searched = no_drive.searched;
  return ", in boxes of " + length_text(space, searched.position) + ", " +
         std::to_string(searched.headings) + " headings and motions of " +
         length_text(space, searched.step) +
         (no_drive.lattice_searched
              ? "; a search on a lattice of half cells and 16 headings found none either"
              : "");
}

}  // namespace

std::string reason_of_headings(const Query& query) {
  const bool of_start = !(std::abs(query.start.heading) <= kLargestHeading);
  return "the heading of the " + std::string(of_start ? "start" : "goal") +
         " is not a number of radians in -1e6..1e6";
}

std::string reason_of_outside_start(const FreeSpace& space, const Query& query) {
  return start_of(space, query) + outside_of(space);
}

std::string reason_of_outside_goal(const FreeSpace& space, const Query& query) {
  return goal_of(space, query.goals.front()) + outside_of(space);
}

std::string reason_of_blocked_start(const FreeSpace& space, const Query& query) {
  return does_not_fit(space, start_of(space, query), query.start);
}

std::string reason_of_blocked_goal(const FreeSpace& space, const Query& query) {
  const Goal& goal = query.goals.front();
  const Pose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  if (goal.heading || space.outline() == nullptr)
    return does_not_fit(space, goal_of(space, goal), pose);
  if (is_too_large(space)) return too_large(space);
  return "the robot fits at " + goal_of(space, goal) + " with no heading that was tried; with " +
         heading_text(0, space.map().frame()) + why_blocked(space, pose).substr(1);
}

std::string reason_of_time_budget(double seconds, const FreeSpace& space, const Query& query) {
  return "no drive from " + start_of(space, query) + " to " + goals_of(space, query) +
         " was found within " + format_number(seconds) +
         " s of CPU time, the time_budget of hybrid_astar: there may be one; a larger budget "
         "searches longer";
}

std::string reason_of_no_drive(const NoDriveFound& no_drive, const FreeSpace& space,
                               const Query& query) {
  const std::string start = start_of(space, query);
  const std::string goal = goals_of(space, query);
  const std::string searched = searched_text(space, no_drive);
  switch (no_drive.why) {
    case NoDriveFound::Why::parted:
      return "no drive leads from " + start + " to " + goal + ": obstacles part them" +
             (space.is_point() ? std::string()
                               : ", even for " + disc_within(space) + ", with a radius of " +
                                     length_text(space, inner_radius_in_cells(space)));
    case NoDriveFound::Why::goal_boxed_in:
      return (query.goals.size() == 1
                  ? goal
                  : "each of the " + std::to_string(query.goals.size()) + " goals") +
             " is boxed in: the robot cannot get there, however it moves";
    case NoDriveFound::Why::start_boxed_in:
      return start + " is boxed in: the robot cannot get from there to " + goal +
             ", however it moves";
    case NoDriveFound::Why::none_found:
      return "no drive from " + start + " to " + goal + " was found at this resolution" + searched +
             "; there may be one all the same";
  }
  return {};
}

}  // namespace wend
