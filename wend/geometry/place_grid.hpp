#pragma once

// PlaceGrid: where the states of a planner lie: in the middles of cells, or on the vertices of a lattice, corners of
// cells whose coordinates are multiples of a spacing. Places are numbered like cells.
//
//   const wend::PlaceGrid places = planner.place_grid();
//   const wend::Point point = places.point({3, 2});  // grid coordinates

#include <cmath>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// Place (i, j) is the point (offset + spacing i, offset + spacing j), in cells.
struct PlaceGrid {
  double offset = 0.5;  // 0.5: the middle of a cell; 0: a corner
  int spacing = 1;      // cells from a place to the next
  int columns = 0;      // of places
  int rows = 0;         // of places

  /// Are the places corners of cells?
  bool on_corners() const { return offset == 0; }

  /// A place in grid coordinates.
  Point point(Cell place) const { return {offset + spacing * place.x, offset + spacing * place.y}; }

  /// The place whose point is nearest, on the grid or not. The point is_near_a_map().
  Cell nearest(Point point) const {
    return {static_cast<int>(std::round((point.x - offset) / spacing)),
            static_cast<int>(std::round((point.y - offset) / spacing))};
  }

  /// Grids are equal if all of their places are.
  friend bool operator==(const PlaceGrid&, const PlaceGrid&) = default;
};

/// The middles of the cells of a map, or of a space.
template <class Space>
PlaceGrid cells_of(const Space& space) {
  return {.offset = 0.5, .spacing = 1, .columns = space.width(), .rows = space.height()};
}

/// The corners of its cells whose coordinates are multiples of the spacing, at least 1.
template <class Space>
PlaceGrid corners_of(const Space& space, int spacing = 1) {
  return {.offset = 0,
          .spacing = spacing,
          .columns = space.width() / spacing + 1,
          .rows = space.height() / spacing + 1};
}

}  // namespace wend
