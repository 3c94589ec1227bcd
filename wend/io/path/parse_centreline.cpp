#include "wend/io/path/parse_centreline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/path/path_columns.hpp"
#include "wend/io/path/path_coordinates.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#'); }

/// Where x_m and y_m stand among the columns of a header.
struct CentrelineHeader {
  PathColumns columns;
  std::size_t x;
  std::size_t y;
};

std::optional<CentrelineHeader> header_of(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
  const char separator = line.find(';') == std::string_view::npos ? ',' : ';';
  PathColumns columns(line, separator, true);
  std::optional<std::size_t> x;
  std::optional<std::size_t> y;
  for (std::size_t i = 0; i < columns.count(); ++i) {
    if (columns.name(i) == "x_m") x = i;
    if (columns.name(i) == "y_m") y = i;
  }
  if (!x || !y) return std::nullopt;
  return CentrelineHeader{std::move(columns), *x, *y};
}

/// The header, past which the reader then is.
std::optional<CentrelineHeader> read_header(LineReader& lines) {
  std::string_view comment;
  LineReader ahead = lines;
  auto line = ahead.next();
  while (line && is_comment(*line)) {
    comment = *line;
    lines = ahead;
    line = ahead.next();
  }
  if (auto header = header_of(comment)) return header;
  auto header = header_of(line.value_or(""));
  lines = ahead;
  return header;
}

Expected<Point, std::string> waypoint(const CentrelineHeader& header, const Frame& frame) {
  if (const auto numbers = header.columns.check_numbers(0); !numbers) {
    return Unexpected<std::string>(numbers.error());
  }
  const Point metres{parse_number(header.columns[header.x]).value_or(0),
                     parse_number(header.columns[header.y]).value_or(0)};
  const Point point = frame.to_grid(metres);
  if (may_be_coordinate_of_pose(point.x) && may_be_coordinate_of_pose(point.y)) return point;
  return Unexpected<std::string>(fmt::format(
      "x_m {:.6g} and y_m {:.6g} are ({:.6g},{:.6g}) in grid coordinates, which must be "
      "in 0..{}",
      metres.x, metres.y, point.x, point.y, kCoordinateEnd));
}

}  // namespace

Expected<Path, IoError> parse_centreline(std::string_view text, const std::string& file,
                                         const Frame& frame) {
  LineReader lines(text);
  auto header = read_header(lines);
  if (!header) {
    return io_failure(file, 1,
                      fmt::format("the first line must be '{}', '{}' or '{}', or name columns x_m "
                                  "and y_m, not {}",
                                  kPathCsvHeader, kDrivenPathCsvHeader, kWaypointCsvHeader,
                                  quote(LineReader(text).next().value_or(""))));
  }
  std::vector<Point> points;
  while (const auto line = lines.next()) {
    if (const auto read = header->columns.read(*line); !read) {
      return io_failure(file, lines.number(), read.error());
    }
    const auto point = waypoint(*header, frame);
    if (!point) return io_failure(file, lines.number(), point.error());
    points.push_back(*point);
  }
  if (points.empty()) return io_failure(file, 0, "no points: a path has at least one");
  return Path::along(std::move(points));
}

}  // namespace wend
