// Where and why a car's query fails, in words.

#include <algorithm>
#include <optional>

#include "wend/base/parse.hpp"
#include "wend/map/place_text.hpp"
#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/robot/zone_name.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

/// A start or goal, as the query names it and as the lattice does.
struct End {
  std::string name;
  Point asked;
  CornerPose place;  // of an end on the map
  bool on_map;
  bool any_heading;
};

End end_of(const CarLattice& lattice, const std::string& name, const Pose& pose, bool any_heading) {
  const auto place = lattice.place_on(pose);
  return {name, pose.point(), place.value_or(CornerPose{}), place.has_value(), any_heading};
}

End start_of(const CarLattice& lattice, const Query& query) {
  return end_of(lattice, "start", query.start, false);
}

End end_at(const CarLattice& lattice, const Goal& goal) {
  const Pose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  return end_of(lattice, "goal", pose, !goal.heading);
}

/// The reason of several hopeless goals is that of the first.
End goal_of(const CarLattice& lattice, const Query& query) {
  return end_at(lattice, query.goals.front());
}

/// The first that a car could stand on: others were no goals of the search that failed.
End searched_goal_of(const CarLattice& lattice, const Query& query) {
  for (const Goal& goal : query.goals) {
    End end = end_at(lattice, goal);
    if (end.on_map && lattice.passable(end.place.vertex)) return end;
  }
  return goal_of(lattice, query);
}

/// "start (3,4,E)", or "start (0.3,0.4,E) m" on a map in metres.
std::string name_of(const CarLattice& lattice, const End& end) {
  const Pose pose = lattice.to_grid(end.place);
  const auto heading = end.any_heading ? std::nullopt : std::optional(pose.heading);
  return end.name + ' ' + pose_text(pose.point(), heading, lattice.free_space().map().frame());
}

std::string outside(const CarLattice& lattice, const End& end) {
  const GridMap& map = lattice.free_space().map();
  if (map.frame().metric) {
    return "the " + end.name + ' ' + metres_text(map.frame().to_metres(end.asked)) +
           " is outside the map, which covers " +
           covered_metres(map.frame(), map.width(), map.height());
  }
  const auto last = [&](int corners) { return std::to_string((corners - 1) * lattice.unit()); };
  std::string text = "the " + end.name + " (" + format_number(end.asked.x) + ',' +
                     format_number(end.asked.y) +
                     ") is outside the map: its grid vertices have x from " + "0 to " +
                     last(lattice.columns()) + " and y from 0 to " + last(lattice.rows());
  if (lattice.unit() > 1) text += ", every " + std::to_string(lattice.unit());
  return text;
}

std::string blocked(const CarLattice& lattice, const End& end) {
  const auto fault = lattice.why_blocked(end.place.vertex);
  if (!fault) return {};
  const std::string text = "the " + name_of(lattice, end) + " is impassable: ";
  const std::string reason(describe(fault->reason));
  const Frame& frame = lattice.free_space().map().frame();
  const std::string away = distance_text(fault->distance, frame) + " away, the robot's radius is " +
                           distance_text(lattice.free_space().radius_in_cells(), frame);
  switch (fault->reason) {
    case BlockReason::obstacle:
    case BlockReason::unknown:
      if (const auto mask = mask_that_blocks(lattice.free_space(), fault->cell.value_or(Cell{}))) {
        return text + "cell " + cell_text(fault->cell.value_or(Cell{})) +
               " next to it is blocked by " + *mask;
      }
      return text + "cell " + cell_text(fault->cell.value_or(Cell{})) + " next to it is " + reason;
    case BlockReason::too_close:
      return text + "the nearest obstacle is " + away;
    case BlockReason::over_edge:
      return text + "the robot would leave the map: its edge is " + away;
    case BlockReason::outside:
    case BlockReason::overlaps:
    case BlockReason::leaves:
      break;
  }
  return text + reason;
}

bool is_boxed_in(const CarLattice& lattice, const CornerPose& place) {
  const CarSpace<RealCarCosts> space(lattice);
  bool boxed_in = true;
  space.for_each_successor(space.state(place), kNoMove,
                           [&](const CarState&, Move, double) { boxed_in = false; });
  return boxed_in;
}

/// Moves can be undone: where none leads away, none leads to.
bool is_boxed_in(const CarLattice& lattice, const End& end) {
  if (!end.any_heading) return is_boxed_in(lattice, end.place);
  return std::all_of(kAllHeadings.begin(), kAllHeadings.end(), [&](Heading heading) {
    return is_boxed_in(lattice, CornerPose{end.place.vertex, heading});
  });
}

std::string unreachable(const CarLattice& lattice, const Query& query) {
  const End start = start_of(lattice, query);
  const End goal = searched_goal_of(lattice, query);
  if (is_boxed_in(lattice, start)) {
    return "no motion primitive leaves the " + name_of(lattice, start);
  }
  if (is_boxed_in(lattice, goal)) {
    return "no motion primitive reaches the " + name_of(lattice, goal);
  }
  return "there is no path from the " + name_of(lattice, start) + " to the " +
         name_of(lattice, goal) + ": obstacles separate them for the car";
}

}  // namespace

std::string reason_on(const CarLattice& lattice, const Query& query, Status status) {
  switch (status) {
    case Status::start_outside:
      return outside(lattice, start_of(lattice, query));
    case Status::goal_outside:
      return outside(lattice, goal_of(lattice, query));
    case Status::start_blocked:
      return blocked(lattice, start_of(lattice, query));
    case Status::goal_blocked:
      return blocked(lattice, goal_of(lattice, query));
    case Status::unreachable:
      return unreachable(lattice, query);
    default:
      return {};
  }
}

}  // namespace wend
