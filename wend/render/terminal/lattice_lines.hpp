#pragma once

// Lines through characters: a car's arcs, drawn with ─ ╮ │ and the like (═ ╗ ║ in reverse), or in
// ASCII with - \ | (= in reverse).

#include <cstdint>
#include <optional>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {

class LatticeLines {
 public:
  /// For that many characters.
  LatticeLines(int columns, int rows, bool ascii) : joins_(columns, rows), ascii_(ascii) {}

  /// A line through characters that follow each other, y down. Nothing is drawn of what lies
  /// outside.
  void add(const std::vector<Cell>& way, bool reverse);

  /// What the lines make of a character, if they touch it.
  std::optional<Glyph> operator[](Cell character) const;

 private:
  /// Which of its eight neighbours a character is joined with, a bit for each Direction.
  struct Joins {
    std::uint8_t ahead = 0;
    std::uint8_t reverse = 0;
  };

  void join(Cell from, Cell to, bool reverse);

  Grid<Joins> joins_;
  bool ascii_;
};

}  // namespace wend
