#pragma once

// The characters of text pictures: what stands for a cell, an arrow, a start. text_picture() and
// text_layers() share them.

#include <optional>
#include <string_view>

#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// What a character in a picture means.
enum class Meaning : unsigned char {
  free,
  obstacle,
  unknown,
  too_close,
  rough,
  expanded,
  expanded_rough,  // on rough ground
  frontier,
  current,
  start_component,
  goal_component,
  move,
  path,
  planned_line,
  smoothed_line,
  driven_line,
  possible_line,
  robot,
  narrowest,
  nearest_free,
  collision,
  start,
  goal,
  // Of a car's picture alone:
  corner,
  axis,
  yard_obstacle,
  ahead,
  reverse,
  pose,
};
inline constexpr int kMeanings = 29;

struct Glyph {
  std::string_view text;  // one column wide, UTF-8
  Meaning meaning = Meaning::free;
};

/// What the map and the robot make of a cell.
Glyph glyph_of(const FreeSpace& space, Cell cell);

/// "." for a multiplier of 1, its digit from 3 to 9, "~" for any other.
Glyph glyph_of_terrain(double multiplier);

Glyph arrow(Direction direction, Meaning meaning);

/// What stands for a character where only ASCII is wanted.
std::string_view ascii_of(std::string_view character);

/// Characters, not bytes, of UTF-8.
std::size_t characters(std::string_view text);

Glyph glyph_of(CellRole role);

/// The same on rough ground, which shows where the search has been.
Glyph glyph_on_rough_ground(CellRole role);

Glyph glyph_of(LineRole role);

/// The cell that a point in grid coordinates lies in, if it is one of the map.
std::optional<Cell> cell_under(const FreeSpace& space, Point point);

/// Writes the scene's arrows over what is there, except over obstacles.
void put_arrows(const Scene& scene, Grid<Glyph>& glyphs);

/// Writes the scene's lines over what is there, later ones over earlier ones.
void put_lines(const Scene& scene, Grid<Glyph>& glyphs);

/// Writes S, G, R (the robot), ! (the narrowest place), N (the nearest free cells) and a cross (the collision) over what is there.
void put_marks(const Scene& scene, Grid<Glyph>& glyphs);

/// A glyph for every cell of the map, without anything that lies on it.
Grid<Glyph> glyphs_of(const FreeSpace& space);

/// The map's row that is drawn as the n-th from the top.
inline int drawn_row(const FreeSpace& space, int n) {
  return space.map().frame().y_up ? space.height() - 1 - n : n;
}

}  // namespace wend
