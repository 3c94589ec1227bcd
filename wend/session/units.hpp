#pragma once

// Units: how people name places and lengths on a map: in metres of the map's frame, or in cells. It turns
// grid coordinates into words for messages.
//
//   const wend::Units units(space.map());
//   report("the door is " + units.length(2 * clearance) + " wide, at " + units.text(door));

#include <cstddef>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/place_text.hpp"

namespace wend {

/// A start or goal in words.
struct Place {
  std::string name;  // "start", "goal"
  Cell cell;         // that it lies in; may lie outside the map
  std::string text;  // "(3,4)" or "(1.25,3.4) m, cell (25,68)"
};

/// Writes places and lengths in words. Lengths in grid coordinates are numbers of cells.
class WEND_API Units {
 public:
  /// Metres if the map's file gave a resolution, else cells.
  explicit Units(const GridMap& map) : Units(map, false) {}

  /// Cells also on a map with a resolution if `cells` is set.
  Units(const GridMap& map, bool cells)
      : frame_(map.frame()),
        width_(map.width()),
        height_(map.height()),
        metric_(frame_.metric && !cells) {}

  /// Are lengths in metres?
  bool metric() const { return metric_; }

  /// The frame of the map.
  const Frame& frame() const { return frame_; }

  /// A place that is known by its cell.
  Place place(const std::string& name, Cell cell) const { return {name, cell, text(cell)}; }

  /// A place that is known by a point in grid coordinates, whether on the map or not.
  Place place(const std::string& name, Point point) const;

  /// A cell: "(3,4)", or its centre in metres: "(1.25,3.4) m, cell (25,68)".
  std::string text(Cell cell) const;

  /// A point in grid coordinates, and the cell that it lies in: "(1.25,3.4) m, cell (25,68)".
  std::string text(Point point) const;

  /// A radius as a front end takes it, rounded down to 4 digits after the point.
  std::string radius(double cells) const;

  /// "2.83 cells" or "0.14 m".
  std::string length(double cells) const;

  /// A number of cells as an area: "57 cells", and "(0.14 m2)" if the map has a resolution.
  std::string area(std::size_t cells) const;

  /// What the map covers: "the cells with x from 0 to 9 and y from 0 to 4".
  std::string extent() const;

  /// The same for the vertices of its cells: from 0 to 10 and from 0 to 5.
  std::string extent_of_corners() const;

  /// A length in these units, in metres.
  double in_metres(double length) const { return metric_ ? length : length * frame_.resolution; }
  /// A length in these units, in cells.
  double in_cells(double length) const { return metric_ ? length / frame_.resolution : length; }

 private:
  Frame frame_;
  int width_;
  int height_;
  bool metric_;
};

}  // namespace wend
