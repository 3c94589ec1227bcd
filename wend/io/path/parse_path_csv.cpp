#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/path/parse_centreline.hpp"
#include "wend/io/path/path_columns.hpp"
#include "wend/io/path/path_coordinates.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

Unexpected<std::string> wrong(std::string what) { return Unexpected<std::string>(std::move(what)); }

Expected<int, std::string> coordinate(const PathColumns& columns, std::size_t column) {
  const auto value = parse_integer<int>(columns[column]);
  if (value && *value >= 0 && *value < kCoordinateEnd) return *value;
  return wrong(wrong_coordinate(columns.name(column), quote(columns[column])));
}

Expected<double, std::string> pose_coordinate(const PathColumns& columns, std::size_t column) {
  const auto value = parse_number(columns[column]);
  if (value && may_be_coordinate_of_pose(*value)) return *value;
  return wrong(wrong_pose_coordinate(columns.name(column), quote(columns[column])));
}

Expected<Point, std::string> point_in(const PathColumns& columns) {
  const auto x = pose_coordinate(columns, 0);
  if (!x) return wrong(x.error());
  const auto y = pose_coordinate(columns, 1);
  if (!y) return wrong(y.error());
  return Point{*x, *y};
}

Expected<double, std::string> heading_in(std::string_view text, bool y_up) {
  if (const auto radians = radians_of_letter(text, y_up)) return *radians;
  const auto radians = parse_number(text);
  if (radians && std::isfinite(*radians)) return *radians;
  return wrong(wrong_heading("heading", quote(text)));
}

Expected<void, std::string> append_cell(Path& path, const PathColumns& columns) {
  const auto x = coordinate(columns, 0);
  if (!x) return wrong(x.error());
  const auto y = coordinate(columns, 1);
  if (!y) return wrong(y.error());
  path.append({*x, *y});
  return columns.check_numbers(2);
}

Expected<void, std::string> append_pose(Path& path, const PathColumns& columns, bool y_up) {
  const auto point = point_in(columns);
  if (!point) return wrong(point.error());
  const auto heading = heading_in(columns[2], y_up);
  if (!heading) return wrong(heading.error());
  path.drive_to({point->x, point->y, *heading});
  return columns.check_numbers(3);
}

Expected<void, std::string> append_waypoint(std::vector<Point>& points,
                                            const PathColumns& columns) {
  const auto point = point_in(columns);
  if (!point) return wrong(point.error());
  points.push_back(*point);
  return columns.check_numbers(2);
}

/// What the comment of a plan that failed says after kNoPathComment.
FailedPlan failed_plan(std::string_view said) {
  const std::size_t colon = said.find(": ");
  const std::string_view reason =
      colon == std::string_view::npos ? std::string_view() : said.substr(colon + 2);
  return {printable(said.substr(0, colon), kLongestStatus), text_line(reason, kLongestReason)};
}

}  // namespace

Expected<Path, IoError> parse_path_csv(std::string_view text, const std::string& file,
                                       const Frame& frame) {
  LineReader lines(text);
  const std::string_view header = lines.next().value_or("");
  if (header.starts_with(kNoPathComment)) {
    return no_path_failure(file, failed_plan(header.substr(kNoPathComment.size())));
  }
  const bool driven = header == kDrivenPathCsvHeader;
  const bool waypoints = header == kWaypointCsvHeader;
  if (!driven && !waypoints && header != kPathCsvHeader) return parse_centreline(text, file, frame);
  PathColumns columns(header, ',', false);
  Path path;
  std::vector<Point> points;
  while (const auto line = lines.next()) {
    auto taken = columns.read(*line);
    if (taken) {
      taken = driven      ? append_pose(path, columns, frame.y_up)
              : waypoints ? append_waypoint(points, columns)
                          : append_cell(path, columns);
    }
    if (!taken) return io_failure(file, lines.number(), taken.error());
  }
  if (waypoints) path = Path::along(std::move(points));
  if (!path.empty()) return path;
  return io_failure(file, 0,
                    fmt::format("no {}: a path has at least one", driven      ? "poses"
                                                                  : waypoints ? "points"
                                                                              : "cells"));
}

}  // namespace wend
