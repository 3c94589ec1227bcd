#pragma once

// Coordinates and poses as people type and read them: metres in the map's frame for maps that have a
// resolution, cells for the others and with --cells. A pose is X,Y,HEADING:
//
//   0,0,E         a grid vertex for the car planner, else a cell, facing east: N, W, E and S are those
//                 of the map on a page
//   0,0,2         the same: N = 0, W = 1, E = 2, S = 3
//   1.5,2,45deg   an angle in the map's frame, from +x towards +y; 0.8rad too
//   18,18,any     a goal with any heading; 18,18 too

#include <optional>
#include <string>
#include <string_view>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/planner/plan.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/path_report.hpp"

namespace wend::cli {

/// A place that was typed: which cell it names.
struct Place {
  std::string name;  // "start", "goal"
  Cell cell;         // may lie outside the map
  std::string text;  // "(3,4)" or "(1.25,3.4) m, cell (25,68)"
};

class Coordinates {
 public:
  Coordinates(const GridMap& map, bool cells)
      : frame_(map.frame()),
        width_(map.width()),
        height_(map.height()),
        metric_(frame_.metric && !cells) {}

  /// Does the user count in metres?
  bool metric() const { return metric_; }

  /// "X,Y": a place in the map's frame, or a cell. Throws InputError for any other text, for one with
  /// a heading too.
  Place parse(const std::string& name, const std::string& typed) const;

  /// The two numbers of "X,Y" in the user's units. Unless these are metres, the numbers must be whole:
  /// they name a `what`, such as "cell". Throws InputError for any other text.
  Point parse_point(const std::string& name, const std::string& typed, std::string_view what) const;

  /// Converts a point from the user's units to grid coordinates, without rounding errors at vertices.
  Point in_grid(Point typed) const;

  const Frame& frame() const { return frame_; }

  /// A place that is known by its cell.
  Place place(const std::string& name, Cell cell) const { return {name, cell, text(cell)}; }

  /// A cell as the user counts.
  std::string text(Cell cell) const;

  /// A point in grid coordinates, and the cell that it lies in: "(1.25,3.4) m, cell (25,68)".
  std::string text(Point point) const;

  /// A radius in cells as --robot-radius takes it, rounded down.
  std::string radius_argument(double cells) const;

  /// A length given in cells: "2.83 cells" or "0.14 m".
  std::string length(double cells) const;

  /// A number of cells as an area: "57 cells", and "(0.14 m2)" where the map has metres.
  std::string area(std::size_t cells) const;

  /// What the map covers: "the cells with x from 0 to 9 and y from 0 to 4".
  std::string extent() const;

  /// The same for its vertices: from 0 to 10 and from 0 to 5.
  std::string extent_of_corners() const;

  /// A length in the user's units, in metres.
  double in_metres(double length) const { return metric_ ? length : length * frame_.resolution; }

  /// The same in cells.
  double in_cells(double length) const { return metric_ ? length / frame_.resolution : length; }

  /// The user's unit of length.
  LengthUnit unit() const { return metric_ ? metres_of(frame_) : LengthUnit{}; }

 private:
  std::string metric_extent() const;

  Frame frame_;
  int width_;
  int height_;
  bool metric_;
};

/// Does the text have a heading, valid or not, after X,Y?
bool has_heading(std::string_view typed);

/// "(3,4)"
std::string cell_text(Cell cell);

/// "160 x 100 cells, 8 x 5 m"
std::string size_text(const GridMap& map);

struct TypedPose {
  Point point;                    // grid coordinates; may lie outside the map
  std::optional<double> heading;  // radians, in grid coordinates; nothing: any
  std::string text;               // "(0,0,E)", "(1.5,2,45deg) m"

  Goal goal() const;

  /// For a picture.
  ScenePlace place() const;
};

/// What whole numbers name: a cell, whose middle is meant, or a vertex where cells meet.
enum class PoseAnchor { cell, corner };

/// A start, which has a heading. Throws InputError for any other text.
TypedPose parse_start_pose(const Coordinates& coordinates, const std::string& typed,
                           PoseAnchor anchor = PoseAnchor::corner);

/// A goal. Throws InputError for any other text.
TypedPose parse_goal_pose(const Coordinates& coordinates, const std::string& typed,
                          PoseAnchor anchor = PoseAnchor::corner);

}  // namespace wend::cli
