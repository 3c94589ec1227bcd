#pragma once

// A small map as text, one character a cell, as the source file looks (maps with y up: last row
// first):
//
//   S→↘.#    #  obstacle       S  start     →  path, towards the next cell
//   ..#↓~    ?  unknown        G  goal      !  the narrowest place
//   .?::G    :  too close for the robot     .  free
//   *  expanded     +  frontier     @  being expanded     s  start's region     g  goal's region
//   ~  rough (a multiplier of 2, or one that is no digit), 3 to 9  rough, by that multiplier
//
// A scene's arrows are shown too, its heatmap is not: see text_numbers() in text_layers.hpp.
//
// UTF-8, '\n' after every row. O(cells).

#include <limits>
#include <string>

#include "wend/map/grid_map.hpp"
#include "wend/render/scene.hpp"

namespace wend {

struct TextStyle {
  bool colours = false;  // ANSI colours
  bool legend = false;   // one more line: what the characters in the picture mean
  int columns = std::numeric_limits<int>::max();  // a longer legend takes several lines
};

std::string text_picture(const Scene& scene, const TextStyle& style = {});

/// Does the map fit into that many columns and rows, one character a cell?
bool fits_as_text(const GridMap& map, int columns, int rows);

}  // namespace wend
