#pragma once

// The poses of lattices: a vertex and a heading in lattice coordinates, and the states of a search. A Place is a CornerPose, whose heading is one of four, or a LatticePose.

#include <bitset>

#include "wend/base/state_id.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/robot/motion_primitives.hpp"

namespace wend {

/// A vertex, and an index in the headings of motion primitives.
struct LatticePose {
  Cell vertex;
  int heading = 0;

  friend bool operator==(const LatticePose&, const LatticePose&) = default;
};

/// A vertex alone, where headings do not matter.
struct VertexPlace {
  Cell vertex{};
  // NOLINTNEXTLINE(readability-identifier-naming): the name that places with headings have for it
  static constexpr int heading = 0;

  constexpr VertexPlace() = default;
  constexpr VertexPlace(Cell cell)  // NOLINT(google-explicit-constructor): a vertex is a cell
      : vertex(cell) {}
};

/// A step between vertices.
struct VertexStep {
  Cell by;
};

constexpr VertexPlace moved(const VertexPlace& place, const VertexStep& step) {
  return Cell{place.vertex.x + step.by.x, place.vertex.y + step.by.y};
}

/// Headings by their indices.
using HeadingSet = std::bitset<MotionPrimitives::kMostHeadings>;

/// A place and its number, (y * columns + x) * headings + heading.
template <class Place>
struct BasicLatticeState {
  StateId number = 0;
  Place place{};
};

}  // namespace wend
