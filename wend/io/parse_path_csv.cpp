#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/io/line_reader.hpp"
#include "wend/io/load_path.hpp"
#include "wend/io/path_coordinates.hpp"
#include "wend/io/path_csv.hpp"
#include "wend/io/quote.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostColumns = 6;

/// The first columns of a line and how many it has.
struct Columns {
  std::array<std::string_view, kMostColumns> texts;
  std::size_t count = 0;
};

Columns columns_of(std::string_view line) {
  Columns columns;
  while (true) {
    const std::size_t end = line.find(',');
    if (columns.count < kMostColumns) columns.texts[columns.count] = line.substr(0, end);
    ++columns.count;
    if (end == std::string_view::npos) return columns;
    line.remove_prefix(end + 1);
  }
}

Unexpected<std::string> wrong(std::string what) { return Unexpected<std::string>(std::move(what)); }

Expected<Columns, std::string> columns_below(std::string_view header, std::string_view line) {
  const Columns columns = columns_of(line);
  const std::size_t expected = columns_of(header).count;
  if (columns.count == expected) return columns;
  return wrong(fmt::format("{} columns, expected {}: {}", columns.count, expected, header));
}

/// Complains about the first column from `first` on that holds no finite number.
Expected<void, std::string> check_numbers(std::string_view header, const Columns& columns,
                                          std::size_t first) {
  for (std::size_t i = first; i < columns.count; ++i) {
    const auto number = parse_number(columns.texts[i]);
    if (number && std::isfinite(*number)) continue;
    return wrong(fmt::format("{} must be a finite number, not {}", columns_of(header).texts[i],
                             quote(columns.texts[i])));
  }
  return {};
}

Expected<int, std::string> coordinate(std::string_view name, std::string_view text) {
  const auto value = parse_integer<int>(text);
  if (value && *value >= 0 && *value < kCoordinateEnd) return *value;
  return wrong(wrong_coordinate(name, quote(text)));
}

Expected<double, std::string> pose_coordinate(std::string_view name, std::string_view text) {
  const auto value = parse_number(text);
  if (value && may_be_coordinate_of_pose(*value)) return *value;
  return wrong(wrong_pose_coordinate(name, quote(text)));
}

Expected<double, std::string> heading_in(std::string_view text, bool y_up) {
  if (const auto radians = radians_of_letter(text, y_up)) return *radians;
  const auto radians = parse_number(text);
  if (radians && std::isfinite(*radians)) return *radians;
  return wrong(wrong_heading("heading", quote(text)));
}

Expected<void, std::string> append_cell(Path& path, std::string_view line) {
  const auto columns = columns_below(kPathCsvHeader, line);
  if (!columns) return wrong(columns.error());
  const auto x = coordinate("x", columns->texts[0]);
  if (!x) return wrong(x.error());
  const auto y = coordinate("y", columns->texts[1]);
  if (!y) return wrong(y.error());
  path.append({*x, *y});
  return check_numbers(kPathCsvHeader, *columns, 2);
}

Expected<void, std::string> append_pose(Path& path, std::string_view line, bool y_up) {
  const auto columns = columns_below(kDrivenPathCsvHeader, line);
  if (!columns) return wrong(columns.error());
  const auto x = pose_coordinate("x", columns->texts[0]);
  if (!x) return wrong(x.error());
  const auto y = pose_coordinate("y", columns->texts[1]);
  if (!y) return wrong(y.error());
  const auto heading = heading_in(columns->texts[2], y_up);
  if (!heading) return wrong(heading.error());
  path.drive_to({*x, *y, *heading});
  return check_numbers(kDrivenPathCsvHeader, *columns, 3);
}

}  // namespace

Expected<Path, IoError> parse_path_csv(std::string_view text, const std::string& file,
                                       const Frame& frame) {
  LineReader lines(text);
  const std::string_view header = lines.next().value_or("");
  const bool driven = header == kDrivenPathCsvHeader;
  if (!driven && header != kPathCsvHeader) {
    return io_failure(file, 1,
                      fmt::format("the first line must be '{}' or '{}', not {}", kPathCsvHeader,
                                  kDrivenPathCsvHeader, quote(header)));
  }
  Path path;
  while (const auto line = lines.next()) {
    const auto appended = driven ? append_pose(path, *line, frame.y_up) : append_cell(path, *line);
    if (!appended) return io_failure(file, lines.number(), appended.error());
  }
  if (!path.empty()) return path;
  return io_failure(file, 0,
                    fmt::format("no {}: a path has at least one", driven ? "poses" : "cells"));
}

}  // namespace wend
