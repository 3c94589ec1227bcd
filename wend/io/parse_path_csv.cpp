#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/line_reader.hpp"
#include "wend/io/load_path.hpp"
#include "wend/io/path_cells.hpp"
#include "wend/io/path_csv.hpp"
#include "wend/io/quote.hpp"

namespace wend {
namespace {

constexpr std::size_t kColumns = 4;
constexpr std::array<std::string_view, kColumns> kNames{"x", "y", "x_m", "y_m"};

/// The first four columns of a line and how many it has.
struct Columns {
  std::array<std::string_view, kColumns> texts;
  std::size_t count = 0;
};

Columns columns_of(std::string_view line) {
  Columns columns;
  while (true) {
    const std::size_t end = line.find(',');
    if (columns.count < kColumns) columns.texts[columns.count] = line.substr(0, end);
    ++columns.count;
    if (end == std::string_view::npos) return columns;
    line.remove_prefix(end + 1);
  }
}

Expected<int, std::string> coordinate(std::string_view name, std::string_view text) {
  const auto value = parse_integer<int>(text);
  if (value && *value >= 0 && *value < kCoordinateEnd) return *value;
  return Unexpected<std::string>(wrong_coordinate(name, quote(text)));
}

Expected<Cell, std::string> cell_in(std::string_view line) {
  const Columns columns = columns_of(line);
  if (columns.count != kColumns) {
    return Unexpected<std::string>(
        fmt::format("{} columns, expected {}: {}", columns.count, kColumns, kPathCsvHeader));
  }
  const auto x = coordinate(kNames[0], columns.texts[0]);
  if (!x) return Unexpected<std::string>(x.error());
  const auto y = coordinate(kNames[1], columns.texts[1]);
  if (!y) return Unexpected<std::string>(y.error());
  for (std::size_t i = 2; i < kColumns; ++i) {
    const auto metres = parse_number(columns.texts[i]);
    if (metres && std::isfinite(*metres)) continue;
    return Unexpected<std::string>(
        fmt::format("{} must be a finite number, not {}", kNames[i], quote(columns.texts[i])));
  }
  return Cell{*x, *y};
}

}  // namespace

Expected<Path, IoError> parse_path_csv(std::string_view text, const std::string& file) {
  LineReader lines(text);
  const std::string_view header = lines.next().value_or("");
  if (header != kPathCsvHeader) {
    return io_failure(
        file, 1, fmt::format("the first line must be '{}', not {}", kPathCsvHeader, quote(header)));
  }
  std::vector<Cell> cells;
  while (const auto line = lines.next()) {
    const auto cell = cell_in(*line);
    if (!cell) return io_failure(file, lines.number(), cell.error());
    cells.push_back(*cell);
  }
  if (cells.empty()) return io_failure(file, 0, "no cells: a path has at least one");
  return Path(std::move(cells));
}

}  // namespace wend
