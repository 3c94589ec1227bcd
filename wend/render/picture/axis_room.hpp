#pragma once

// AxisRoom: how much of a picture the axes of a car's lattice take (see axes.hpp), and how many of
// its corners have a number.

#include "wend/render/scene.hpp"

namespace wend {

inline constexpr double kAxisFontSize = 15;  // pixels
inline constexpr double kAxisTick = 5;       // pixels
inline constexpr double kAxisGap = 10;       // between a tick and its number: a mark may lie there

/// Of a digit in that font.
inline constexpr double kAxisDigitHeight = 0.73 * kAxisFontSize;

/// Pixels at the sides of a map that its axes take; none without a unit.
struct AxisRoom {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  int across() const { return left + right; }
  int down() const { return top + bottom; }
};

AxisRoom axis_room(const Scene& scene);

/// How many cells lie between two numbers, where a cell has that many pixels.
int axis_step(const Scene& scene, double scale);

}  // namespace wend
