#include "cli/arguments/typed_pose.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/heading.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

constexpr std::string_view kAny = "any";
constexpr std::string_view kHeadingsThatAre =
    "N, W, E or S (or 0, 1, 2, 3), or an angle as 45deg or 0.8rad";

/// "45deg" and "0.8rad" in radians.
std::optional<double> parse_angle(std::string_view text) {
  const bool degrees = text.ends_with("deg");
  if (!degrees && !text.ends_with("rad")) return std::nullopt;
  const auto number = parse_number(text.substr(0, text.size() - 3));
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return degrees ? radians_from(*number) : *number;
}

/// The angle in grid coordinates of one in the map's frame; that of a heading, but for rounding, is
/// that heading's.
double angle_in_grid(double angle, const Frame& frame) {
  constexpr double kRounding = 1e-9;
  const double in_grid = frame.to_grid(Pose{0, 0, angle}).heading;
  const double straight = radians_of(nearest_heading(in_grid, frame.y_up), frame.y_up);
  return std::abs(normalized_angle(in_grid - straight)) < kRounding ? straight : in_grid;
}

std::optional<double> parse_typed_heading(std::string_view text, const Frame& frame) {
  if (const auto heading = parse_heading(text)) return radians_of(*heading, frame.y_up);
  if (const auto angle = parse_angle(text)) return angle_in_grid(*angle, frame);
  return std::nullopt;
}

/// X,Y, and what follows the second comma.
struct Parts {
  std::string point;
  std::optional<std::string> heading;
};

Parts parts_of(const std::string& typed) {
  const auto first = typed.find(',');
  const auto second = first == std::string::npos ? first : typed.find(',', first + 1);
  if (second == std::string::npos) return {typed, std::nullopt};
  return {typed.substr(0, second),
          std::string(trimmed(std::string_view(typed).substr(second + 1)))};
}

TypedPose parse(const Coordinates& coordinates, const std::string& name, const std::string& typed,
                const Parts& parts) {
  const Point point = coordinates.parse_point(name, parts.point, "corner");
  return {coordinates.in_grid(point), std::nullopt,
          fmt::format("({}){}", typed, coordinates.metric() ? " m" : "")};
}

[[noreturn]] void refuse_heading(const std::string& name, const std::string& typed,
                                 const std::string& heading, std::string_view rest) {
  throw InputError(fmt::format("--{}: {}: the heading {} is not {}{}", name, quote(typed),
                               quote(heading), kHeadingsThatAre, rest));
}

}  // namespace

Goal TypedPose::goal() const {
  return heading ? Goal(Pose{point.x, point.y, *heading}) : Goal(point);
}

ScenePlace TypedPose::place() const {
  return heading ? ScenePlace(Pose{point.x, point.y, *heading}) : ScenePlace(point);
}

TypedPose parse_start_pose(const Coordinates& coordinates, const std::string& typed) {
  const Parts parts = parts_of(typed);
  TypedPose pose = parse(coordinates, "start", typed, parts);
  if (!parts.heading) {
    throw InputError(
        fmt::format("--start: {} has no heading, and a car needs one: {},E say; it is {}",
                    quote(typed), typed, kHeadingsThatAre));
  }
  pose.heading = parse_typed_heading(*parts.heading, coordinates.frame());
  if (!pose.heading) refuse_heading("start", typed, *parts.heading, "");
  return pose;
}

TypedPose parse_goal_pose(const Coordinates& coordinates, const std::string& typed) {
  const Parts parts = parts_of(typed);
  TypedPose pose = parse(coordinates, "goal", typed, parts);
  if (!parts.heading || *parts.heading == kAny) return pose;
  pose.heading = parse_typed_heading(*parts.heading, coordinates.frame());
  if (!pose.heading) refuse_heading("goal", typed, *parts.heading, ", nor any");
  return pose;
}

}  // namespace wend::cli
