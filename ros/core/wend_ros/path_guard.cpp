#include "wend_ros/path_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace wend_ros {
namespace {

double reach_of(const wend::VelocityLimits& limits, double period, double look_ahead) {
  constexpr double kPeriods = 2;  // until a command has an effect
  return limits.speed * limits.speed / (2 * limits.acceleration) +
         kPeriods * period * limits.speed + look_ahead;
}

/// How the robot stands on a leg.
double heading_on(const wend::RouteLeg& leg, double along) {
  return wend::turned_round(leg.line.at(along), leg.reverse).heading;
}

/// Poses of the robot from a place of a leg on, until `left` metres are used up; turns in place between its lines.
void append_leg(const wend::RouteLeg& leg, double along, double& left,
                std::vector<wend::MapPose>& poses) {
  const auto points = leg.line.points();
  const auto lengths = leg.line.along();
  const wend::MapPose begin = leg.line.at(along);
  poses.push_back({begin.x, begin.y, heading_on(leg, along)});
  for (std::size_t piece = leg.line.piece_at(along); piece + 1 < points.size() && left > 0;
       ++piece) {
    const double from = std::max(along, lengths[piece]);
    const double to = std::min(lengths[piece + 1], from + left);
    const double heading = heading_on(leg, lengths[piece]);
    const wend::MapPose end = leg.line.at(to);
    if (poses.back().heading != heading) {
      poses.push_back({poses.back().x, poses.back().y, heading});
    }
    poses.push_back({end.x, end.y, heading});
    left = to < lengths[piece + 1] ? 0 : left - (to - from);
  }
}

/// The poses of the robot along the next `reach` metres of a route, and its turn at the end if they hold it.
std::vector<wend::MapPose> way_ahead(const wend::Route& route, std::size_t leg, double along_leg,
                                     double reach) {
  std::vector<wend::MapPose> poses;
  double left = reach;
  for (double along = along_leg; leg < route.legs().size() && left > 0; ++leg, along = 0) {
    append_leg(route.legs()[leg], along, left, poses);
  }
  const auto heading = route.final_heading();
  if (left > 0 && heading) poses.push_back({route.end().x, route.end().y, *heading});
  return poses;
}

wend::MapPose taken_to(const wend::MapPose& frame, const wend::MapPose& pose) {
  const double cosine = std::cos(frame.heading);
  const double sine = std::sin(frame.heading);
  return {frame.x + cosine * pose.x - sine * pose.y, frame.y + sine * pose.x + cosine * pose.y,
          wend::normalized_angle(frame.heading + pose.heading)};
}

wend::Pose to_grid(const GuardedSpace& on, const wend::MapPose& pose) {
  return on.space.map().frame().to_grid(taken_to(on.route_in_map, pose));
}

/// A number of a message, to the centimetre.
double rounded(double metres) {
  constexpr double kParts = 100;
  return std::round(kParts * metres) / kParts;
}

std::string text_of(const wend::PathCollision& collision, const wend::FreeSpace& space) {
  const wend::Frame& frame = space.map().frame();
  const wend::MapPoint at = frame.to_metres(collision.point);
  std::ostringstream text;
  text << "blocked " << rounded(collision.along * frame.resolution) << " m ahead, at ("
       << rounded(at.x) << ", " << rounded(at.y) << "): the path "
       << wend::describe(collision.kind);
  return text.str();
}

/// The turn with which a robot that stands at the beginning of a leg faces along it.
std::vector<wend::MapPose> turn_before(const wend::MapPose& robot, const wend::MapPose& first) {
  constexpr double kAligned = 0.1;  // radians: less is corrected on the way
  if (std::abs(wend::normalized_angle(first.heading - robot.heading)) < kAligned) return {};
  return {robot, {robot.x, robot.y, first.heading}};
}

}  // namespace

wend::Footprint swept_footprint(const wend::Footprint& robot, double margin) {
  const double radius = robot.circumscribed_radius();
  const wend::Polygon* outline = robot.outline();
  if (outline == nullptr) return wend::Footprint::disc(std::max(0.0, radius - margin));
  wend::Point middle;
  const auto& corners = outline->corners();
  for (const wend::Point corner : corners) {
    middle.x += corner.x / static_cast<double>(corners.size());
    middle.y += corner.y / static_cast<double>(corners.size());
  }
  double farthest = 0;
  for (const wend::Point corner : corners) {
    farthest = std::max(farthest, std::hypot(corner.x - middle.x, corner.y - middle.y));
  }
  const double share = std::max(0.5, 1 - margin / farthest);
  std::vector<wend::Point> nearer;
  nearer.reserve(corners.size());
  for (const wend::Point corner : corners) {
    nearer.push_back(
        {middle.x + share * (corner.x - middle.x), middle.y + share * (corner.y - middle.y)});
  }
  auto polygon = wend::Polygon::make(std::move(nearer));
  if (!polygon) return robot;
  return wend::Footprint::polygon(*std::move(polygon)).value_or(robot);
}

PathGuard::PathGuard(const wend::VelocityLimits& limits, double period, double inscribed_radius,
                     const GuardOptions& options)
    : reach_(reach_of(limits, period, options.look_ahead)),
      join_radius_(std::max(0.0, inscribed_radius - options.join_margin)),
      escape_(options.escape) {}

std::optional<std::string> PathGuard::why_blocked(const GuardedSpace& on, const wend::Route& route,
                                                  const RobotOnRoute& robot) const {
  const auto way = way_ahead(route, robot.leg, robot.along_leg, reach_);
  std::vector<wend::MapPose> all;
  if (robot.along_leg == 0 && robot.pose) all = turn_before(*robot.pose, way.front());
  all.insert(all.end(), way.begin(), way.end());
  std::vector<wend::Pose> poses;
  poses.reserve(all.size());
  for (const wend::MapPose& pose : all) poses.push_back(to_grid(on, pose));
  // Only a point can pass between two obstacles that touch at a corner, and its planner has been told so.
  constexpr auto kCorners = wend::Adjacency::edges_and_corners;
  const double escape = escape_ / on.space.map().frame().resolution;  // cells
  const auto checked =
      wend::check_with_lead(wend::Path::through(std::move(poses)), on.space, escape, kCorners);
  if (!checked.collision) return std::nullopt;
  return text_of(*checked.collision, on.space);
}

bool PathGuard::can_reach(const GuardedSpace& on, wend::MapPoint from, wend::MapPoint to) const {
  const wend::Pose begin = to_grid(on, {from.x, from.y});
  const wend::Pose end = to_grid(on, {to.x, to.y});
  const double length = std::hypot(end.x - begin.x, end.y - begin.y);
  const double course = std::atan2(end.y - begin.y, end.x - begin.x);
  const double clearance = wend::arc_clearance(on.space, {{begin.x, begin.y, course}, length, 0});
  const double needed = join_radius_ / on.space.map().frame().resolution;
  return clearance > 0 && clearance >= needed;
}

}  // namespace wend_ros
