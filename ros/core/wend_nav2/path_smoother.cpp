// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "wend/control/given_route.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend_nav2/path_pieces.hpp"
#include "wend_nav2/pose_faults.hpp"

namespace wend_nav2 {
namespace {

using Poses = PathSmoother::Poses;

// `drive` smooths arcs, of which a list of poses does not tell.
constexpr std::array<std::string_view, 2> kSmoothers{"gradient", "curvature"};
constexpr std::string_view kUnsafe = "unsafe";

bool is_offered(std::string_view smoother) {
  return std::ranges::find(kSmoothers, smoother) != kSmoothers.end();
}

/// The smoothed points as poses; the first and the last keep their headings.
void append_piece(Poses& poses, const std::vector<wend::MapPoint>& points,
                  std::span<const wend::MapPose> piece, bool reverse) {
  const double turned = reverse ? wend::kPi : 0;
  poses.push_back(piece.front());
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double way = std::atan2(points[i + 1].y - points[i].y, points[i + 1].x - points[i].x);
    poses.push_back({points[i].x, points[i].y, wend::normalized_angle(way + turned)});
  }
}

wend::Unexpected<Failure> no_smoothing(FailureKind kind, std::string message) {
  return wend::Unexpected<Failure>(Failure{kind, std::move(message)});
}

wend::Path waypoints(std::span<const wend::MapPose> piece, const wend::Frame& frame) {
  std::vector<wend::Point> points;
  for (const wend::MapPose& pose : piece) points.push_back(frame.to_grid(pose.point()));
  return wend::Path::along(std::move(points));
}

/// The first pose that is not on the costmap, if any: what is not, no smoother has to look for.
std::optional<std::string> pose_outside(const Poses& path, const wend::FreeSpace& space) {
  const wend::Frame& frame = space.map().frame();
  const auto is_inside = [&](const wend::MapPose& pose) {
    const wend::Point at = frame.to_grid(pose.point());
    return at.x >= 0 && at.y >= 0 && at.x <= space.width() && at.y <= space.height();
  };
  const auto outside = std::ranges::find_if_not(path, is_inside);
  if (outside == path.end()) return std::nullopt;
  const wend::MapPoint low = frame.to_metres(wend::Point{});
  const wend::MapPoint high = frame.to_metres(
      wend::Point{static_cast<double>(space.width()), static_cast<double>(space.height())});
  return "pose " + std::to_string(outside - path.begin()) + " of the path, " + place_of(*outside) +
         ", is outside the costmap, which reaches from " + place_of({low.x, low.y, 0}) + " to " +
         place_of({high.x, high.y, 0});
}

}  // namespace

SmootherSchema smoother_schema(std::string_view smoother) {
  SmootherSchema schema{.name = {.name = std::string(kSmootherParameter),
                                 .aliases = {},
                                 .kind = wend::OptionKind::choice,
                                 .default_value = std::string(kSmoothers.front()),
                                 .choices = {kSmoothers.begin(), kSmoothers.end()},
                                 .help = "name of the smoother"},
                        .plugin = wend::option_schema<SmootherOptions>(),
                        .smoother = {}};
  const wend::SmootherInfo* info =
      is_offered(smoother) ? wend::smoothers().find(smoother) : nullptr;
  if (info == nullptr) return schema;
  std::ranges::copy_if(info->options, std::back_inserter(schema.smoother),
                       [](const wend::OptionInfo& option) { return option.name != kUnsafe; });
  return schema;
}

wend::Expected<SmootherSettings, wend::Error> smoother_settings_from(
    std::string_view smoother, const wend::OptionValues& values) {
  const SmootherSchema schema = smoother_schema(smoother);
  if (!is_offered(smoother)) {
    return wend::Unexpected<wend::Error>(wend::option_text::option_error(
        schema.name.name, wend::option_text::unknown_choice(smoother, schema.name.choices)));
  }
  SmootherSettings settings{.smoother = std::string(smoother), .plugin = {}, .options = {}};
  wend::OptionValues of_plugin;
  for (const auto& value : values) {
    const bool own = std::ranges::find(schema.smoother, value.first, &wend::OptionInfo::name) !=
                     schema.smoother.end();
    (own ? settings.options : of_plugin).push_back(value);
  }
  auto plugin = wend::parse_options<SmootherOptions>(of_plugin);
  if (!plugin) return wend::Unexpected<wend::Error>(std::move(plugin.error()));
  settings.plugin = *plugin;
  const auto made = wend::make_smoother(smoother, settings.options);
  if (!made) return wend::Unexpected<wend::Error>(made.error());
  return settings;
}

wend::Expected<PathSmoother::Result, Failure> PathSmoother::smooth(
    const Poses& path, const RobotShape& robot, const std::function<bool()>& time_is_up) {
  if (auto fault = fault_of(path)) {
    return no_smoothing(FailureKind::no_valid_path, *std::move(fault));
  }
  if (path.size() < 3) return Result{path};
  const ObstacleRule rule = settings_.plugin.obstacles;
  auto smoothed = smooth_by(rule_for(rule), path, robot, time_is_up);
  // Planners that keep the robot's centre out of inscribed cells come nearer to obstacles than its outline allows.
  const bool may_be_nearer = rule == ObstacleRule::automatic && robot.inflated &&
                             robot.footprint.outline() == nullptr && !smoothed &&
                             smoothed.error().kind == FailureKind::no_valid_path;
  if (!may_be_nearer) return smoothed;
  auto nearer = smooth_by(ObstacleRule::inscribed, path, robot, time_is_up);
  return nearer ? nearer : smoothed;
}

wend::Expected<PathSmoother::Result, Failure> PathSmoother::smooth_by(
    ObstacleRule rule, const Poses& path, const RobotShape& robot,
    const std::function<bool()>& time_is_up) {
  session_.set_robot(robot_for(rule, robot, settings_.plugin.allow_unknown));
  const auto brought = costmap_.bring_to(session_, scale_for(rule, 0));
  if (!brought) return no_smoothing(FailureKind::other, brought.error().message);
  const auto view = session_.view();
  if (!view) return no_smoothing(FailureKind::other, view.error().message);
  if (auto outside = pose_outside(path, view->space)) {
    return no_smoothing(FailureKind::no_valid_path, *std::move(outside));
  }
  const auto smoother = wend::make_smoother(settings_.smoother, settings_.options);
  if (!smoother) return no_smoothing(FailureKind::invalid_planner, smoother.error().message);
  const wend::Frame& frame = view->space.map().frame();
  Result result;
  const std::vector<std::size_t> cuts = cuts_of(path);
  const bool faces = wend::headings_count(path);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const std::span<const wend::MapPose> piece =
        std::span(path).subspan(cuts[i], cuts[i + 1] - cuts[i] + 1);
    if (time_is_up()) {
      result.complete = false;
      result.poses.insert(result.poses.end(), piece.begin(), piece.end() - 1);
      continue;
    }
    const auto smoothed = (*smoother)(waypoints(piece, frame), view->space, time_is_up);
    if (!smoothed) return no_smoothing(FailureKind::no_valid_path, smoothed.error().message);
    result.complete = result.complete && !smoothed->stopped;
    append_piece(result.poses, smoothed->path.points_in_metres(frame), piece,
                 faces && in_reverse(piece));
  }
  result.poses.push_back(path.back());
  return result;
}

}  // namespace wend_nav2
