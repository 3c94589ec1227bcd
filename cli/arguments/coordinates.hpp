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
#include "wend/geometry/place_grid.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/planner/plan.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/path_report.hpp"
#include "wend/session/units.hpp"

namespace wend::cli {

/// The numbers that a person typed: metres in the map's frame, or cells.
struct TypedPoint {
  double x = 0;
  double y = 0;
};

/// Reads what people type, and says places in the same units.
class Coordinates : public Units {
 public:
  Coordinates(const GridMap& map, bool cells) : Units(map, cells) {}

  /// "X,Y": a place in the map's frame, or a cell. Throws InputError for any other text, for one with
  /// a heading too.
  Place parse(const std::string& name, const std::string& typed) const;

  /// The two numbers of "X,Y" in the user's units. Unless these are metres, the numbers must be whole:
  /// they name a `what`, such as "cell". Throws InputError for any other text.
  TypedPoint parse_point(const std::string& name, const std::string& typed,
                         std::string_view what) const;

  /// The point that parse() finds the cell of, in grid coordinates: the middle of a cell that is typed by its
  /// numbers.
  Point parse_in_grid(const std::string& name, const std::string& typed) const;

  /// Converts a point from the user's units to grid coordinates, without rounding errors at vertices.
  Point in_grid(TypedPoint typed) const;

  /// The map's frame for texts of poses: not metric where the user's unit is a cell.
  Frame frame_of_texts() const {
    Frame texts = frame();
    texts.metric = metric();
    return texts;
  }

  /// The user's unit of length.
  LengthUnit unit() const { return metric() ? metres_of(frame()) : LengthUnit{}; }
};

/// Does the text have a heading, valid or not, after X,Y?
bool has_heading(std::string_view typed);

/// "160 x 100 cells, 8 x 5 m"
std::string size_text(const GridMap& map);

/// How far from a goal a path may end.
struct GoalTolerance {
  double distance = 0;  // cells
  double heading = 0;   // radians
};

/// "DISTANCE" or "DISTANCE,DEGREES", the distance in the user's units; empty: none. Throws InputError for any
/// other text.
GoalTolerance parse_goal_tolerance(const Coordinates& coordinates, const std::string& typed);

struct TypedPose {
  Point point;                    // grid coordinates; may lie outside the map
  std::optional<double> heading;  // radians, in grid coordinates; nothing: any
  std::string text;               // "(0,0,E)", "(1.5,2,45deg) m"

  Goal goal() const;

  /// For messages; `name` is "start" or "goal".
  Place named(const std::string& name) const;

  /// For a picture.
  ScenePlace place() const;
};

/// A start, which has a heading. Whole numbers name a cell, whose middle is meant, or a corner: what `places` are.
/// Throws InputError for any other text.
TypedPose parse_start_pose(const Coordinates& coordinates, const std::string& typed,
                           const PlaceGrid& places = {.offset = 0});

/// The same for a goal. Throws InputError for any other text.
TypedPose parse_goal_pose(const Coordinates& coordinates, const std::string& typed,
                          const PlaceGrid& places = {.offset = 0});

}  // namespace wend::cli
