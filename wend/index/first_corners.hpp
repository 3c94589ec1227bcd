#pragma once

// The first corners of a cell: where the shortest paths that start there may turn first.
//
// A shortest path can be drawn so that it goes diagonally first, then straight, and turns only at
// jump points. So its first turn lies where a straight ray, cast from the cell or from a cell on
// one of its four diagonals, meets the first jump point of its direction; or it never turns. The
// cost from the cell to such a corner is octile_cost(), diagonal steps first.
//
// With D the distance in the CornerGraph, the distance between two cells s and t is the minimum of
//   octile(s, t)                          if the octile path that goes diagonally first, from s or
//                                         from t, is free
//   octile(s, a) + D(a, c) + octile(c, t) for a of first(s), c of first(t)
//   octile(s, c) + octile(c, t)           for c of first(t), if the octile path from s to c that goes
//                                         diagonally first is free
// Proof: draw a shortest path from t. If it never turns, the first term is its cost. Otherwise it turns
// first at a c of first(t). Draw the rest from s: either it turns first at an a of first(s), or it never
// turns and s sees c. If s is a corner, {s} may replace first(s), and the third term is not needed; the
// same holds for t.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

/// The first corners of all cells, computed backwards from the corners. O(cells + the lists).
class AllFirstCorners {
 public:
  explicit AllFirstCorners(const Corners& corners, const IndexBuilding& building = {});

  /// In ascending order; empty for a blocked cell.
  std::span<const std::uint32_t> of(Cell cell) const {
    const std::size_t number = number_of(cell);
    return std::span(corners_).subspan(begins_[number], begins_[number + 1] - begins_[number]);
  }

 private:
  std::size_t number_of(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }

  int width_;
  std::vector<std::size_t> begins_;  // by cell, and the end
  std::vector<std::uint32_t> corners_;
};

// CellComponents: the passable cells of a map that are not corners, grouped by their first corners.
// Neighbouring cells mostly have the same first corners, so an index stores one record for all of them.

class CellComponents {
 public:
  /// O(the lists of all cells). Components are numbered by their first cell, row by row.
  CellComponents(const Corners& corners, const AllFirstCorners& first,
                 const IndexBuilding& building = {});

  std::size_t size() const { return begins_.size() - 1; }

  /// Never empty.
  std::span<const Cell> cells(std::size_t component) const {
    return std::span(cells_).subspan(begins_[component],
                                     begins_[component + 1] - begins_[component]);
  }

 private:
  std::vector<std::size_t> begins_{0};  // by component, and the end
  std::vector<Cell> cells_;
};

}  // namespace wend
