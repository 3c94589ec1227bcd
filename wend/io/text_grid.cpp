#include "wend/io/text_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "wend/io/drawn_row.hpp"
#include "wend/io/line_reader.hpp"
#include "wend/io/quote.hpp"

namespace wend {
namespace {

struct TextCell {
  CellState state;
  double terrain = 1;
};

constexpr double kRough = 2;

std::optional<TextCell> cell_of(char letter) {
  switch (letter) {
    case '0':
    case '.':
      return TextCell{CellState::free};
    case '1':
    case '#':
    case '@':
      return TextCell{CellState::occupied};
    case '?':
      return TextCell{CellState::unknown};
    case '~':
      return TextCell{CellState::free, kRough};
    default:
      if (letter < '2' || letter > '9') return std::nullopt;
      return TextCell{CellState::free, static_cast<double>(letter - '0')};
  }
}

/// The cells of all rows so far, and how wide the rows are.
struct Rows {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<CellState> states;
  std::vector<double> terrain;  // empty while every cell costs 1

  void append(TextCell cell) {
    if (cell.terrain != 1 && terrain.empty()) terrain.assign(states.size(), 1);
    if (cell.terrain != 1 || !terrain.empty()) terrain.push_back(cell.terrain);
    states.push_back(cell.state);
  }
};

/// Appends a row; what is wrong with it, empty if nothing is.
std::string append_row(std::string_view line, Rows& rows) {
  const std::size_t before = rows.states.size();
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ' ' || line[i] == '\t') continue;
    const auto cell = cell_of(line[i]);
    if (!cell) return fmt::format("unknown letter {} in column {}", quote(line[i]), i + 1);
    rows.append(*cell);
  }
  const std::size_t width = rows.states.size() - before;
  if (rows.height == 0) rows.width = width;
  if (width != rows.width) {
    return fmt::format("this row has {} cells, the first one has {}", width, rows.width);
  }
  ++rows.height;
  return rows.states.size() > GridMap::kMaxCells ? "too many cells" : "";
}

template <class T>
Grid<T> grid_of(const Rows& rows, const std::vector<T>& values) {
  if (values.empty()) return {};
  Grid<T> grid(static_cast<int>(rows.width), static_cast<int>(rows.height));
  for (int y = 0; y < grid.height(); ++y) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(y) * grid.width();
    std::copy(begin, begin + grid.width(), grid.row(y).begin());
  }
  return grid;
}

/// The letter of a cell; nothing for terrain that has none.
std::optional<char> letter_of(CellState state, double terrain) {
  if (state == CellState::occupied) return '#';
  if (state == CellState::unknown) return terrain == 1 ? std::optional('?') : std::nullopt;
  if (terrain == 1) return '.';
  if (terrain > kLargestTextTerrain || terrain != std::round(terrain)) return std::nullopt;
  return static_cast<char>('0' + static_cast<int>(terrain));
}

}  // namespace

Expected<LoadedMap, IoError> parse_text_grid(std::string_view text, const std::string& file) {
  Rows rows;
  LineReader lines(text);
  std::size_t blank_line = 0;
  while (const auto line = lines.next()) {
    if (is_blank(*line)) {
      if (blank_line == 0) blank_line = lines.number();
      continue;
    }
    if (blank_line > 0) return io_failure(file, blank_line, "a blank line before a row of cells");
    const std::string wrong = append_row(*line, rows);
    if (!wrong.empty()) return io_failure(file, lines.number(), wrong);
  }
  if (rows.states.empty()) return io_failure(file, 0, "no cells");
  return LoadedMap{GridMap(grid_of(rows, rows.states), {}, grid_of(rows, rows.terrain)),
                   MapFormat::text_grid,
                   {}};
}

Expected<std::string, std::string> format_text_grid(const GridMap& map) {
  std::string text;
  text.reserve(map.size() + static_cast<std::size_t>(map.height()));
  for (int from_top = 0; from_top < map.height(); ++from_top) {
    const int y = drawn_row(from_top, map.height(), map.frame().y_up);
    for (int x = 0; x < map.width(); ++x) {
      const auto letter = letter_of(map.state({x, y}), map.terrain({x, y}));
      if (!letter) {
        return Unexpected<std::string>(
            fmt::format("a text grid cannot hold the terrain {} of cell ({},{}), only whole "
                        "multipliers up to 9 of free cells",
                        map.terrain({x, y}), x, y));
      }
      text += *letter;
    }
    text += '\n';
  }
  return text;
}

}  // namespace wend
