// Text grids: a map as people type it.
//
//   . . # .        0 .    free
//   . 3 # ?        1 # @  blocked
//   ~ . . .        ?      unknown
//                  ~      rough: free, a step costs twice its length
//                  2..9   free, a step costs that many times its length
//
// One line a row, row 0 on top; blanks or tabs between the cells are allowed. LF or CRLF; blank
// lines after the last row are skipped. Beware: 1 is a blocked cell, not a cost.

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/io/map/map_format.hpp"

namespace wend {
namespace {

struct TextCell {
  CellState state;
  double terrain = 1;
};

constexpr double kRough = 2;
constexpr double kLargestTextTerrain = 9;

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

  /// Appends a row. Returns an error text, empty on success.
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
    const std::size_t rows = rows_ ? static_cast<std::size_t>(rows_->height()) : 0;
    if (states_.size() > GridMap::kMaxCells / (rows + 1)) {
      return fmt::format("too many cells, the limit is {}", GridMap::kMaxCells);
    }
    if (!rows_) begin(line.size());
    assert(rows_);
    const auto width = static_cast<std::size_t>(rows_->width());
    if (states_.size() != width) {
      return fmt::format("expected {} cells as in the first row, not {}", width, states_.size());
    }
    rows_->append(states_, rough ? terrain_ : std::span<const double>());
    return {};
  }

  bool empty() const { return !rows_; }

  /// To be called after at least one row.
  GridMap finish() {
    assert(rows_);
    return *std::move(*rows_).finish();
  }

 private:
  /// The text has at least a byte for a cell, so its size limits the memory that is reserved.
  void begin(std::size_t length_of_line) {
    rows_.emplace(static_cast<int>(states_.size()));
    rows_->reserve(static_cast<int>(
        std::min(size_of_text_ / (length_of_line + 1) + 1, GridMap::kMaxCells / states_.size())));
  }

  std::size_t size_of_text_;
  std::optional<GridMapBuilder> rows_;
  std::vector<CellState> states_;  // of the current row
  std::vector<double> terrain_;
};

bool is_text_grid(std::string_view bytes) {
  const std::string_view first = LineReader(bytes).next().value_or("");
  return !is_blank(first) && std::ranges::all_of(first, [](char letter) {
    return letter == ' ' || letter == '\t' || cell_of(letter);
  });
}

/// Takes linear time and the memory of the map.
Expected<LoadedMap, Error> load_text_grid(LineReader lines, const std::string& file) {
  TextRows rows(lines.size());
  std::size_t blank_line = 0;
  while (const auto line = lines.next()) {
    if (is_blank(*line)) {
      if (blank_line == 0) blank_line = lines.number();
      continue;
    }
    if (blank_line > 0) return file_failure(file, blank_line, "blank line before a row of cells");
    const std::string wrong = rows.append(*line);
    if (!wrong.empty()) return file_failure(file, lines.number(), wrong);
  }
  if (rows.empty()) return file_failure(file, 0, "the text grid has no cells");
  return LoadedMap{rows.finish(), MapFormat::text_grid};
}

/// The letter of a cell that a text grid can hold.
char letter_of(CellState state, double terrain) {
  if (state == CellState::occupied) return '#';
  if (state == CellState::unknown) return '?';
  return terrain == 1 ? '.' : static_cast<char>('0' + static_cast<int>(terrain));
}

Expected<MapFiles, Error> save_text_grid(const GridMap& map, const std::filesystem::path&) {
  std::string text;
  text.reserve(map.size() + static_cast<std::size_t>(map.height()));
  for (const int y : rows_from_top(map)) {
    for (int x = 0; x < map.width(); ++x) text += letter_of(map.state({x, y}), map.terrain({x, y}));
    text += '\n';
  }
  return MapFiles{std::move(text)};
}

}  // namespace

MapFormatInfo text_grid_format() {
  return {.format = MapFormat::text_grid,
          .name = "text grid",
          .noun = "a text grid",
          .extensions = {".txt", ".grid"},
          .saved_extensions = {".txt", ".grid"},
          .largest_terrain = kLargestTextTerrain,
          .terrain_values = "whole numbers",
          .nearest_terrain =
              [](double terrain) { return std::min(std::round(terrain), kLargestTextTerrain); },
          .recognises = is_text_grid,
          .load_lines = load_text_grid,
          .save = save_text_grid};
}

}  // namespace wend
