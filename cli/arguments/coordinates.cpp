#include "cli/arguments/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

// Stands for a place so far away that a cell's numbers cannot hold it.
constexpr Cell kFarOutside{-1, -1};

/// The two finite numbers of "X,Y" or "X, Y".
std::optional<TypedPoint> two_numbers(std::string_view typed) {
  const std::size_t comma = typed.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = parse_number(trimmed(typed.substr(0, comma)));
  const auto y = parse_number(trimmed(typed.substr(comma + 1)));
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) return std::nullopt;
  return TypedPoint{*x, *y};
}

bool is_whole(double number) { return number == std::floor(number); }

double whole_but_for_rounding(double number) {
  constexpr double kRounding = 1e-9;
  const double whole = std::round(number);
  return std::abs(number - whole) < kRounding ? whole : number;
}

bool fits_cell(double number) {
  return std::abs(number) <= static_cast<double>(std::numeric_limits<int>::max());
}

constexpr std::string_view kAny = "any";
constexpr std::string_view kHeadingsThatAre =
    "N, W, E or S (or 0, 1, 2, 3), or an angle such as 45deg or 0.8rad";

/// "45deg" and "0.8rad" in radians.
std::optional<double> parse_angle(std::string_view text) {
  const bool degrees = text.ends_with("deg");
  if (!degrees && !text.ends_with("rad")) return std::nullopt;
  const auto number = parse_number(text.substr(0, text.size() - 3));
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return degrees ? radians_from(*number) : *number;
}

/// Converts an angle from the map's frame to grid coordinates. An angle that is a heading, up to
/// rounding, becomes exactly that heading's.
double angle_in_grid(double angle, const Frame& frame) {
  constexpr double kRounding = 1e-9;
  const double in_grid = frame.to_grid(MapPose{0, 0, angle}).heading;
  const double straight = radians_of(nearest_heading(in_grid));
  return std::abs(normalized_angle(in_grid - straight)) < kRounding ? straight : in_grid;
}

std::optional<double> parse_typed_heading(std::string_view text, const Frame& frame) {
  if (const auto heading = parse_heading(text, frame)) return radians_of(*heading);
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
                const Parts& parts, const PlaceGrid& places) {
  const bool of_cells = !places.on_corners();
  Point point =
      coordinates.in_grid(coordinates.parse_point(name, parts.point, of_cells ? "cell" : "corner"));
  if (of_cells && !coordinates.metric()) point = {point.x + 0.5, point.y + 0.5};
  return {point, std::nullopt, fmt::format("({}){}", typed, coordinates.metric() ? " m" : "")};
}

[[noreturn]] void refuse_heading(const std::string& name, const std::string& typed,
                                 const std::string& heading, std::string_view rest) {
  throw InputError(fmt::format("--{}: {}: the heading {} is not {}{}", name, quote(typed),
                               quote(heading), kHeadingsThatAre, rest));
}

}  // namespace

Place Coordinates::parse(const std::string& name, const std::string& typed) const {
  if (has_heading(typed)) {
    throw InputError(
        fmt::format("--{}: {} has a heading, and grid planners do not use one: leave it out, or "
                    "use a planner for poses: --planner hybrid_astar, lattice or car",
                    name, quote(typed)));
  }
  const TypedPoint point = parse_point(name, typed, "cell");
  if (metric()) {
    const MapPoint metres{point.x, point.y};
    const std::string text = metres_text(metres);
    const auto cell = frame().cell_at(metres);
    if (!cell) return {name, kFarOutside, text};
    return {name, *cell, text + ", cell " + cell_text(*cell)};
  }
  if (!fits_cell(point.x) || !fits_cell(point.y)) return {name, kFarOutside, "(" + typed + ")"};
  const Cell cell{static_cast<int>(point.x), static_cast<int>(point.y)};
  return {name, cell, cell_text(cell)};
}

TypedPoint Coordinates::parse_point(const std::string& name, const std::string& typed,
                                    std::string_view what) const {
  const auto point = two_numbers(typed);
  if (!point) {
    throw InputError(fmt::format("--{}: {} is not X,Y, two finite numbers", name, quote(typed)));
  }
  if (!metric() && (!is_whole(point->x) || !is_whole(point->y))) {
    throw InputError(
        fmt::format("--{0}: {1} is not a {2}: the coordinates of a {2} are whole numbers{3}", name,
                    quote(typed), what, frame().metric ? "; without --cells, X,Y are metres" : ""));
  }
  return *point;
}

Point Coordinates::in_grid(TypedPoint typed) const {
  if (!metric()) return {typed.x, typed.y};
  const Point point = frame().to_grid(MapPoint{typed.x, typed.y});
  return {whole_but_for_rounding(point.x), whole_but_for_rounding(point.y)};
}

Point Coordinates::parse_in_grid(const std::string& name, const std::string& typed) const {
  const Point point = in_grid(parse_point(name, typed, "cell"));
  return metric() ? point : Point{point.x + 0.5, point.y + 0.5};
}

GoalTolerance parse_goal_tolerance(const Coordinates& coordinates, const std::string& typed) {
  if (typed.empty()) return {};
  const std::size_t comma = typed.find(',');
  const auto number = [&](std::string_view text) {
    const auto value = parse_number(trimmed(text));
    if (value && std::isfinite(*value) && *value >= 0) return *value;
    throw InputError(
        fmt::format("--goal-tolerance: {} is not a distance in {}, of at least 0, or a distance "
                    "and an angle in degrees: 0.5 or 0.5,10",
                    quote(typed), coordinates.metric() ? "metres" : "cells"));
  };
  const double distance = number(std::string_view(typed).substr(0, comma));
  const double degrees =
      comma == std::string::npos ? 0 : number(std::string_view(typed).substr(comma + 1));
  return {coordinates.in_cells(distance), radians_from(degrees)};
}

bool has_heading(std::string_view typed) { return std::count(typed.begin(), typed.end(), ',') > 1; }

std::string size_text(const GridMap& map) {
  const Frame& frame = map.frame();
  std::string text = fmt::format("{} x {} cells", map.width(), map.height());
  if (frame.metric) {
    text += fmt::format(", {:.4g} x {:.4g} m", map.width() * frame.resolution,
                        map.height() * frame.resolution);
  }
  return text;
}

Goal TypedPose::goal() const {
  return heading ? Goal(Pose{point.x, point.y, *heading}) : Goal(point);
}

Place TypedPose::named(const std::string& name) const {
  const bool fits = fits_cell(point.x) && fits_cell(point.y);
  return {name, fits ? cell_at(point) : kFarOutside, text};
}

ScenePlace TypedPose::place() const {
  return heading ? ScenePlace(Pose{point.x, point.y, *heading}) : ScenePlace(point);
}

TypedPose parse_start_pose(const Coordinates& coordinates, const std::string& typed,
                           const PlaceGrid& places) {
  const Parts parts = parts_of(typed);
  TypedPose pose = parse(coordinates, "start", typed, parts, places);
  if (!parts.heading) {
    throw InputError(
        fmt::format("--start: {} has no heading, and planners of poses need one, for example {},E; "
                    "a heading is {}",
                    quote(typed), typed, kHeadingsThatAre));
  }
  pose.heading = parse_typed_heading(*parts.heading, coordinates.frame());
  if (!pose.heading) refuse_heading("start", typed, *parts.heading, "");
  return pose;
}

TypedPose parse_goal_pose(const Coordinates& coordinates, const std::string& typed,
                          const PlaceGrid& places) {
  const Parts parts = parts_of(typed);
  TypedPose pose = parse(coordinates, "goal", typed, parts, places);
  if (!parts.heading || *parts.heading == kAny) return pose;
  pose.heading = parse_typed_heading(*parts.heading, coordinates.frame());
  if (!pose.heading) refuse_heading("goal", typed, *parts.heading, ", nor any");
  return pose;
}

}  // namespace wend::cli
