#pragma once

// Glyphs: the characters of text pictures, what they mean, and how rows of them become text.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {

/// What a character in a picture means, in the order of the legend: most interesting first.
enum class Meaning : unsigned char {
  start,
  goal,
  path,
  pose,     // a car's
  ahead,    // driven
  reverse,  // driven
  planned_line,
  smoothed_line,
  driven_line,
  possible_line,
  robot,
  collision,
  narrowest,
  nearest_free,
  current,
  frontier,
  expanded,
  expanded_rough,  // on rough ground
  start_component,
  goal_component,
  move,
  obstacle,
  yard_obstacle,  // where a car drives
  rough_road,     // where a car drives
  too_close,
  unknown,
  rough,
  free,
  corner,  // of a car's lattice
  // In no legend:
  axis,
  blank,
};
inline constexpr std::size_t kMeanings = 31;

struct Glyph {
  std::string_view text;  // one column wide, UTF-8
  Meaning meaning = Meaning::free;
};

/// The character that stands for it alone; of rough ground, see glyph_of_terrain().
Glyph glyph_of(Meaning meaning);

/// What the map and the robot make of a cell.
Glyph glyph_of(const FreeSpace& space, Cell cell);

/// "." for a multiplier of 1, its digit from 3 to 9, "~" for any other.
Glyph glyph_of_terrain(double multiplier);

/// Rough ground shows where the search has been.
Glyph glyph_of(CellRole role, bool on_rough_ground = false);

Glyph glyph_of(LineRole role);

Glyph arrow(Direction direction, Meaning meaning);

/// What stands for a character where only ASCII is wanted.
std::string_view ascii_of(std::string_view character);

/// A glyph for every cell of the map, without anything that lies on it.
Grid<Glyph> glyphs_of(const FreeSpace& space);

/// Writes the scene's arrows over what is there, except over obstacles.
void put_arrows(const Scene& scene, Grid<Glyph>& glyphs);

/// Writes S, G, R (the robot), ! (the narrowest place), N (the nearest free cells) and a cross (the
/// collision) over what is there.
void put_marks(const Scene& scene, Grid<Glyph>& glyphs);

/// The picture of a scene whose places are corners (see text_picture.hpp), row by row from the top.
Grid<Glyph> lattice_glyphs(const Scene& scene, const TextStyle& style);

/// Does the lattice fit into these columns and rows with the narrowest cells?
bool lattice_fits(const Scene& scene, int columns, int rows);

/// Lines through characters: a car's arcs, drawn with ─ ╮ │ and the like (═ ╗ ║ in reverse), or in
/// ASCII with - \ | (= in reverse).
class GlyphLines {
 public:
  /// For that many characters.
  GlyphLines(int columns, int rows, bool ascii) : joins_(columns, rows), ascii_(ascii) {}

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

/// The rows as text, '\n' after each, without blanks at their ends; then the legend of what occurs,
/// on as many lines as it takes, if the style wants it. `order` says which row comes first.
std::string as_text(const Grid<Glyph>& glyphs, const RowOrder& order, const Scene& scene,
                    const TextStyle& style);

}  // namespace wend
