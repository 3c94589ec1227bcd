#pragma once

// DirectionMap: ways with a direction. What a move costs in a cell may depend on where it leads: one-way zones,
// lanes, slopes.
//
// Each cell multiplies the cost of a unit of length by a factor for the heading of the move, at least 1, or forbids
// it. A step between two cells costs its length times the mean of what both cells say of its heading; if one of them
// forbids it, it is not allowed. So a step is judged by the cell that it leaves and by the one that it enters. A line
// costs in each cell that it crosses what this cell says of its heading. What counts is where the robot's base point
// moves, not where the robot looks: in reverse it moves against its own heading. Turning in place is always allowed.
//
//   arrow   headings within the tolerance of the arrow's are free; the others cost `against` times as much, or are
//           forbidden if that is infinite
//   slope   climbing a unit of height costs `climb` units of way more than the way, descending one `descend` more
//
// The factors of several arrows and slopes in a cell are multiplied. A factor is rounded to 1/256, a half up, and at
// least 1, so estimates that are admissible without directions remain so.
//
//   wend::Grid<double> headings(map.width(), map.height(), std::nan(""));  // no arrow
//   for (int x = 0; x < map.width(); ++x) headings[{x, 4}] = 0;            // row 4 leads towards +x
//   const auto one_way = wend::with_arrows(map, headings);
//   if (!one_way) return report(one_way.error().message);

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// How strict arrows are.
struct ArrowOptions {
  double tolerance = kPi / 2;  // radians, 0 to pi: headings this near to an arrow's are free
  double factor =
      std::numeric_limits<double>::infinity();  // of the other headings, 1 to 1e4; infinite:
                                                // forbidden
};

/// What slopes cost.
struct SlopeOptions {
  double climb = 0;    // units of way that a unit of height upwards costs, 0 to 1e4
  double descend = 0;  // the same downwards
};

/// An arrow in a cell, in grid coordinates.
struct Arrow {
  double heading = 0;    // radians from +x towards +y, in (-pi, pi]
  double tolerance = 0;  // as in ArrowOptions
  double against = 1;    // the factor of ArrowOptions

  friend auto operator<=>(const Arrow&, const Arrow&) = default;
};

/// A slope in a cell, in grid coordinates.
struct Slope {
  double rise_x = 0;   // height per unit of length towards +x
  double rise_y = 0;   // the same towards +y
  double climb = 0;    // as in SlopeOptions
  double descend = 0;  // as in SlopeOptions

  friend auto operator<=>(const Slope&, const Slope&) = default;
};

/// All that a cell says of headings.
struct DirectionRule {
  std::vector<Arrow> arrows = {};  // one for each mask
  std::vector<Slope> slopes = {};  // the same

  /// The factor for a heading in radians, at least 1; infinite: forbidden.
  WEND_API double factor(double heading) const;

  friend auto operator<=>(const DirectionRule&, const DirectionRule&) = default;
};

/// The rules of all cells. Cells with equal rules share them: a cell takes four bytes.
class WEND_API DirectionMap {
 public:
  /// The factor 1, and what stands for an infinite one.
  static constexpr std::uint32_t kOne = 256;
  static constexpr std::uint32_t kForbidden = 0;  // instead of a factor

  /// No cell has a rule.
  DirectionMap(int width, int height);

  /// The number of columns.
  int width() const { return codes_.width(); }
  /// The number of rows.
  int height() const { return codes_.height(); }

  /// The rule of a cell of the map; empty where all headings cost the same. O(1).
  const DirectionRule& rule(Cell cell) const { return rules_[codes_[cell]]; }
  /// Do all headings cost the same in a cell of the map?
  bool none_at(Cell cell) const { return codes_[cell] == 0; }

  /// Adds to the rule of a cell. O(log rules).
  void add(Cell cell, const DirectionRule& rule);

  /// The factor of a step that leaves or enters a cell of the map, in steps of 1/256; kForbidden. O(1).
  std::uint32_t factor(Cell cell, Direction direction) const {
    return factors_[codes_[cell]][static_cast<std::size_t>(direction)];
  }
  /// The same for any heading in radians. O(arrows and slopes of the cell).
  std::uint32_t factor(Cell cell, double heading) const;

 private:
  std::uint32_t code_of(const DirectionRule& rule);

  Grid<std::uint32_t> codes_;  // in rules_; 0: none
  std::vector<DirectionRule> rules_;
  std::vector<std::array<std::uint32_t, kDirections>> factors_;  // of rules_
  std::map<DirectionRule, std::uint32_t> known_;                 // the codes of rules_
};

/// A step of a cost map times a factor of a DirectionMap, rounded; kForbidden. All planners and path costs use it.
inline std::uint32_t directed_steps(std::uint32_t steps, std::uint32_t factor) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::uint64_t product =
      (std::uint64_t{steps} * factor + DirectionMap::kOne / 2) / DirectionMap::kOne;
  return static_cast<std::uint32_t>(product < kMost ? product : kMost);
}

/// The heading of a direction in radians, from +x towards +y.
WEND_API double heading_of(Direction direction);

/// The map with an arrow in every cell whose heading is not NaN, in radians in the map's frame (from +x towards +y; the
/// frame's yaw counts), besides those that it has. Fails with invalid_map if the grids differ in size or a heading is
/// infinite, and with invalid_option if the options are out of range. O(cells).
WEND_API Expected<GridMap, Error> with_arrows(const GridMap& map, const Grid<double>& headings,
                                              const ArrowOptions& options = {});

/// The map with the slopes of heights, in the map's unit of length; NaN: unknown, as if the ground was flat there. The
/// slope of a cell is that between its neighbours. Fails as with_arrows() does. O(cells).
WEND_API Expected<GridMap, Error> with_heights(const GridMap& map, const Grid<double>& heights,
                                               const SlopeOptions& options = {});

/// How a grid lies on another one.
struct RulePlacement {
  double turn = 0;        // heading 0 of the one is this on the other, in radians
  bool mirrored = false;  // does y grow the other way?
  double stretch = 1;     // lengths on the one, for one on the other: what slopes are multiplied by
};

/// A rule on another grid.
WEND_API DirectionRule placed(const DirectionRule& rule, const RulePlacement& placement);

/// The directions of a map, to be added to; without a cell that has a rule if it has none.
WEND_API DirectionMap directions_of(const GridMap& map);

}  // namespace wend
