#include "wend/io/path/path_csv.hpp"

#include <fmt/format.h>
#include <cassert>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "wend/base/parse.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/path/path_coordinates.hpp"
#include "wend/io/text.hpp"
#include "wend/path/gears.hpp"

namespace wend {
namespace {

constexpr std::string_view kCellHeader = "x,y,x_m,y_m";
constexpr std::string_view kPoseHeader = "x,y,heading,x_m,y_m,yaw,gear";
constexpr std::string_view kOldPoseHeader = "x,y,heading,x_m,y_m,yaw";
constexpr std::string_view kWaypointHeader = "x_grid,y_grid,x_m,y_m,yaw";
constexpr std::string_view kNoPathComment = "# no path: ";
constexpr std::size_t kLongestHeader = 60;  // in an error
constexpr std::size_t kLongestColumnName = 20;

/// Reads lines that all have the same columns, and keeps the first error.
class PathColumns {
 public:
  /// `header` names the columns; its text must outlive this object. If `trims`, blanks around names and
  /// values are ignored.
  PathColumns(std::string_view header, char separator, bool trims)
      : header_(printable(header, kLongestHeader)), separator_(separator), trims_(trims) {
    names_ = split(header);
  }

  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  /// Reads a line.
  void read(std::string_view line) {
    texts_ = split(line);
    if (texts_.size() == names_.size()) return;
    fail(fmt::format("{} columns, expected {}: {}", texts_.size(), names_.size(), header_));
    texts_.resize(names_.size());
  }

  // Values of the line.

  double number(std::size_t column) const { return parse_number(texts_[column]).value_or(0); }

  int cell_coordinate(std::size_t column) {
    const auto value = parse_integer<int>(texts_[column]);
    if (value && may_be_coordinate_of_cell(*value)) return *value;
    fail(wrong_coordinate(names_[column], quote(texts_[column])));
    return 0;
  }

  double coordinate(std::size_t column) {
    const auto value = parse_number(texts_[column]);
    if (value && may_be_coordinate_of_pose(*value)) return *value;
    fail(wrong_pose_coordinate(names_[column], quote(texts_[column])));
    return 0;
  }

  double heading(std::size_t column, bool y_up) {
    if (const auto radians = radians_of_letter(texts_[column], y_up)) return *radians;
    const auto radians = parse_number(texts_[column]);
    if (radians && may_be_heading(*radians)) return *radians;
    fail(wrong_heading(names_[column], quote(texts_[column])));
    return 0;
  }

  /// All columns from `first` on must be finite numbers.
  void check_numbers(std::size_t first) {
    for (std::size_t i = first; i < names_.size(); ++i) {
      const auto number = parse_number(texts_[i]);
      if (number && std::isfinite(*number)) continue;
      return fail(fmt::format("{} must be a finite number, not {}",
                              printable(names_[i], kLongestColumnName), quote(texts_[i])));
    }
  }

  void fail(std::string what) {
    if (wrong_.empty()) wrong_ = std::move(what);
  }

  const std::string& wrong() const { return wrong_; }

 private:
  std::vector<std::string_view> split(std::string_view line) const {
    auto fields = fields_of(line, separator_);
    if (trims_) std::ranges::transform(fields, fields.begin(), trimmed);
    return fields;
  }

  std::string header_;
  char separator_;
  bool trims_;
  std::vector<std::string_view> names_;
  std::vector<std::string_view> texts_;
  std::string wrong_;
};

/// Reads all lines; `take` takes the values of each line from the columns. Fails at the first error.
template <class Take>
Expected<void, Error> read_lines(LineReader& lines, PathColumns& columns, const std::string& file,
                                 const Take& take) {
  while (const auto line = lines.next()) {
    columns.read(*line);
    take();
    if (!columns.wrong().empty()) return file_failure(file, lines.number(), columns.wrong());
  }
  return {};
}

Unexpected<Error> empty_path(const std::string& file, std::string_view what) {
  return file_failure(file, 0, fmt::format("the path is empty: expected at least one {}", what));
}

/// The columns of a header that has x_m and y_m; nothing for other lines.
std::optional<PathColumns> centreline_header(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
  PathColumns columns(line, line.find(';') == std::string_view::npos ? ',' : ';', true);
  if (columns.find("x_m") && columns.find("y_m")) return columns;
  return std::nullopt;
}

/// Reads the header: the last of the leading comments, or the line after them.
std::optional<PathColumns> read_centreline_header(LineReader& lines) {
  std::string_view comment;
  LineReader ahead = lines;
  auto line = ahead.next();
  while (line && trimmed(*line).starts_with('#')) {
    comment = *line;
    lines = ahead;
    line = ahead.next();
  }
  if (auto header = centreline_header(comment)) return header;
  lines = ahead;
  return centreline_header(line.value_or(""));
}

Point centreline_point(PathColumns& columns, const Frame& frame) {
  columns.check_numbers(0);
  const auto x = columns.find("x_m");
  const auto y = columns.find("y_m");
  assert(x && y);
  const MapPoint metres{columns.number(*x), columns.number(*y)};
  const Point point = frame.to_grid(metres);
  if (!may_be_coordinate_of_pose(point.x) || !may_be_coordinate_of_pose(point.y)) {
    columns.fail(
        fmt::format("x_m {:.6g} and y_m {:.6g} are ({:.6g},{:.6g}) in grid coordinates, "
                    "which must be in -{}..{}",
                    metres.x, metres.y, point.x, point.y, kCoordinateEnd, kCoordinateEnd));
  }
  return point;
}

/// Parses a text without the header of another path format.
Expected<Path, PathFileError> parse_centreline(std::string_view text, const std::string& file,
                                               const Frame& frame) {
  LineReader lines(text);
  auto columns = read_centreline_header(lines);
  if (!columns) {
    return file_failure(
        file, 1,
        fmt::format(
            "the first line must be '{}', '{}' or '{}', or name columns x_m and y_m, not {}",
            kCellHeader, kPoseHeader, kWaypointHeader,
            quote(LineReader(text).next().value_or(""))));
  }
  std::vector<Point> points;
  const auto read = read_lines(lines, *columns, file,
                               [&] { points.push_back(centreline_point(*columns, frame)); });
  if (!read) return Unexpected<PathFileError>(read.error());
  if (points.empty()) return empty_path(file, "point");
  return Path::along(std::move(points));
}

std::string heading_text(double radians, const Frame& frame) {
  const auto heading = exact_heading(radians);
  return heading ? std::string(letter_of(*heading, frame)) : format_number(radians);
}

/// "0.075,0.075"
std::string metres_text(MapPoint metres) {
  return format_number(metres.x) + "," + format_number(metres.y);
}

/// Of a path over cells.
std::string csv_of_cells(const Path& path, const Frame& frame) {
  std::string text = fmt::format("{}\n", kCellHeader);
  for (const Point point : path.points()) {
    const Cell cell = cell_at(point);
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", cell.x, cell.y,
                   metres_text(frame.to_metres(point)));
  }
  return text;
}

/// The point of a line with a cell: its centre, unless a map has metres and they say another point of it.
Point point_in(Cell cell, MapPoint metres, const Frame& frame) {
  constexpr double kRounding = 1e-6;  // cells
  const Point centre = centre_of(cell);
  if (!frame.metric) return centre;
  const Point point = frame.to_grid(metres);
  const bool inside = std::abs(point.x - centre.x) <= 0.5 && std::abs(point.y - centre.y) <= 0.5;
  return inside && distance(point, centre) > kRounding ? point : centre;
}

/// A path over cells of which the first and the last point are given.
Path ending_at(Path path, Point first, Point last) {
  const auto cells = path.cells();
  if (first == centre_of(cells.front()) && last == centre_of(cells.back())) return path;
  std::vector<Point> points = path.points();
  points.front() = first;
  if (points.size() > 1) points.back() = last;
  return Path::over_cells(std::move(points));
}

// {fmt} also writes the shortest text, but does not write a million as 1e+06.

std::string csv_of_waypoints(std::span<const Pose> poses, const Frame& frame) {
  std::string text = fmt::format("{}\n", kWaypointHeader);
  for (const Pose& pose : poses) {
    const MapPose metres = frame.to_metres(pose);
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", pose.x, pose.y,
                   metres_text(metres.point()), format_number(metres.heading));
  }
  return text;
}

/// The gear of the piece that leads to each pose; the first has that of the piece that begins there.
std::string csv_of_poses(const Path& path, const Frame& frame) {
  std::vector<int> gears = gears_of(path);
  gears.insert(gears.begin(), gears.empty() ? 0 : gears.front());
  std::string text = fmt::format("{}\n", kPoseHeader);
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const Pose& pose = path.driven_poses()[i];
    const MapPose metres = frame.to_metres(pose);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", pose.x, pose.y,
                   heading_text(pose.heading, frame), metres_text(metres.point()),
                   format_number(metres.heading), gears[i]);
  }
  return text;
}

}  // namespace

std::string path_csv(const Path& path, const Frame& frame) {
  if (path.leads_over_cells()) return csv_of_cells(path, frame);
  return path.visit([&](std::span<const Cell>) { return csv_of_cells(path, frame); },
                    [&](std::span<const Point>) { return csv_of_waypoints(path.poses(), frame); },
                    [&](const JoinedPoses&) { return csv_of_poses(path, frame); });
}

std::string no_path_csv(const FailedPlan& plan, std::string_view header) {
  std::string comment = fmt::format("{}{}: {}", kNoPathComment, plan.status, plan.reason);
  std::ranges::replace_if(
      comment, [](char letter) { return letter == '\n' || letter == '\r'; }, ' ');
  return fmt::format("{}\n{}\n", comment, header);
}

Expected<Path, PathFileError> parse_path_csv(std::string_view text, const std::string& file,
                                             const Frame& frame) {
  LineReader lines(text);
  const std::string_view header = lines.next().value_or("");
  if (header.starts_with(kNoPathComment)) {
    const std::string_view said = header.substr(kNoPathComment.size());
    const std::size_t colon = std::min(said.find(": "), said.size());
    const std::string_view reason = said.substr(std::min(colon + 2, said.size()));
    return no_path_failure(file, failed_plan(said.substr(0, colon), reason));
  }
  PathColumns columns(header, ',', false);
  Path path;
  std::vector<Point> points;
  Expected<void, Error> read;
  if (header == kCellHeader) {
    std::optional<Point> first;
    Point last;
    read = read_lines(lines, columns, file, [&] {
      const int x = columns.cell_coordinate(0);
      path.append({x, columns.cell_coordinate(1)});
      columns.check_numbers(2);
      last = point_in(path.cells().back(), {columns.number(2), columns.number(3)}, frame);
      if (!first) first = last;
    });
    if (first && read) path = ending_at(std::move(path), *first, last);
  } else if (header == kPoseHeader || header == kOldPoseHeader) {
    read = read_lines(lines, columns, file, [&] {
      const Point point{columns.coordinate(0), columns.coordinate(1)};
      path.drive_to({point.x, point.y, columns.heading(2, frame.y_up)});
      columns.check_numbers(3);
    });
  } else if (header == kWaypointHeader) {
    read = read_lines(lines, columns, file, [&] {
      points.push_back({columns.coordinate(0), columns.coordinate(1)});
      columns.check_numbers(2);
    });
    path = Path::along(std::move(points));
  } else {
    return parse_centreline(text, file, frame);
  }
  if (!read) return Unexpected<PathFileError>(read.error());
  if (!path.empty()) return path;
  const bool poses = header == kPoseHeader || header == kOldPoseHeader;
  return empty_path(file, header == kCellHeader ? "cell" : poses ? "pose" : "point");
}

}  // namespace wend
