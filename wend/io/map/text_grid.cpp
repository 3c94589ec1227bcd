#include "wend/io/map/text_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/io/map/drawn_row.hpp"
#include "wend/io/quote.hpp"
#include "wend/map/grid_map.hpp"

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

/// Takes rows of letters.
class TextRows {
 public:
  explicit TextRows(std::size_t size_of_text) : size_of_text_(size_of_text) {}

  /// What is wrong with the row, empty if nothing is.
  std::string append(std::string_view line) {
    states_.clear();
    terrain_.clear();
    bool rough = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == ' ' || line[i] == '\t') continue;
      const auto cell = cell_of(line[i]);
      if (!cell) return fmt::format("unknown letter {} in column {}", quote(line[i]), i + 1);
      states_.push_back(cell->state);
      terrain_.push_back(cell->terrain);
      rough = rough || cell->terrain != 1;
    }
    if (states_.size() > GridMap::kMaxCells) return "too many cells";
    if (!rows_) begin(line.size());
    assert(rows_);
    const auto width = static_cast<std::size_t>(rows_->width());
    if (states_.size() != width) {
      return fmt::format("this row has {} cells, the first one has {}", states_.size(), width);
    }
    if ((static_cast<std::size_t>(rows_->height()) + 1) * width > GridMap::kMaxCells) {
      return "too many cells";
    }
    rows_->append(states_, rough ? terrain_ : std::span<const double>());
    return {};
  }

  bool empty() const { return !rows_; }

  /// After the first row.
  GridMap finish() {
    assert(rows_);
    return std::move(*rows_).finish();
  }

 private:
  /// The text has at least a byte for a cell, so that its size says how much memory is in order.
  void begin(std::size_t length_of_line) {
    rows_.emplace(static_cast<int>(states_.size()));
    rows_->reserve(static_cast<int>(
        std::min(size_of_text_ / (length_of_line + 1) + 1, GridMap::kMaxCells / states_.size())));
  }

  std::size_t size_of_text_;
  std::optional<GridMapBuilder> rows_;
  std::vector<CellState> states_;  // of the row at hand
  std::vector<double> terrain_;
};

/// The letter of a cell; nothing for terrain that has none.
std::optional<char> letter_of(CellState state, double terrain) {
  if (state == CellState::occupied) return '#';
  if (state == CellState::unknown) return terrain == 1 ? std::optional('?') : std::nullopt;
  if (terrain == 1) return '.';
  if (terrain > kLargestTextTerrain || terrain != std::round(terrain)) return std::nullopt;
  return static_cast<char>('0' + static_cast<int>(terrain));
}

}  // namespace

bool looks_like_text_grid(std::string_view bytes) {
  const std::string_view first = LineReader(bytes).next().value_or("");
  return !is_blank(first) && std::all_of(first.begin(), first.end(), [](char letter) {
    return letter == ' ' || letter == '\t' || cell_of(letter);
  });
}

Expected<LoadedMap, IoError> parse_text_grid(LineReader lines, const std::string& file) {
  TextRows rows(lines.size());
  std::size_t blank_line = 0;
  while (const auto line = lines.next()) {
    if (is_blank(*line)) {
      if (blank_line == 0) blank_line = lines.number();
      continue;
    }
    if (blank_line > 0) return io_failure(file, blank_line, "a blank line before a row of cells");
    const std::string wrong = rows.append(*line);
    if (!wrong.empty()) return io_failure(file, lines.number(), wrong);
  }
  if (rows.empty()) return io_failure(file, 0, "no cells");
  return LoadedMap{rows.finish(), MapFormat::text_grid, {}};
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
