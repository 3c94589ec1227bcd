#include "wend/robot/robot_fields.hpp"

#include <array>

namespace wend {
namespace {

using Options = FreeSpaceOptions;

constexpr double kLongest = Footprint::kLargestRadius;
constexpr std::array<std::string_view, 2> kPolicies{"blocked", "free"};

template <class Policy>
Policy policy_of(double value) {
  return value == 2 ? Policy::free : Policy::blocked;
}

void put_outside(Options& robot, double value, double /*resolution*/) {
  robot.outside.reset();
  if (value != 0) robot.outside = policy_of<OutsidePolicy>(value);
}

constexpr auto kFields = std::to_array<RobotField>(
    {{{"robot_radius", OptionKind::number, "m", kLongest, 0, "radius of the robot; 0: a point",
       "radius"},
      [](Options& robot, double value, double) { robot.footprint = Footprint::disc(value); }},
     {{"unknown", OptionKind::choice, "", 2, 1, "whether unknown cells are blocked or free", "",
       kPolicies},
      [](Options& robot, double value, double) {
        robot.unknown = policy_of<UnknownPolicy>(value);
      }},
     {{"outside", OptionKind::choice, "", 2, 0,
       "outside of the map: with free the robot's disc may extend beyond the map's edge; by "
       "default "
       "blocked for maps in metres, free for maps in cells",
       "", kPolicies},
      &put_outside},
     {{"clearance_distance",
       OptionKind::number,
       "m",
       kLongest,
       0,
       "distance to keep from obstacles where there is room, measured from the robot's edge; "
       "nearer cells cost more; 0: off",
       "",
       {},
       "keep_away"},
      [](Options& robot, double value, double) { robot.clearance_distance = value; }},
     {{"clearance_cost",
       OptionKind::number,
       "",
       1e6,
       4,
       "additional cost of a cell where the robot would touch an obstacle, as a multiple of the "
       "cell's cost; it falls to 0 at the clearance distance",
       "",
       {},
       "keep_away_cost"},
      [](Options& robot, double value, double) { robot.clearance_cost = value; }}});

}  // namespace

std::span<const RobotField> robot_fields() { return kFields; }

const RobotField* robot_field(std::string_view name) { return find_field(robot_fields(), name); }

}  // namespace wend
