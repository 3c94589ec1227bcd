#pragma once

// Scene: the content of a picture: a map for one robot, and the things on it. Every kind of picture
// (text, terminal, PNG, SVG) is made from a Scene.
//
//   wend::Scene scene{.space = space};
//   scene.path = plan->path;
//   scene.start = wend::centre_of({1, 1});
//   scene.goals = {wend::centre_of({8, 5})};
//   std::cout << wend::text_picture(scene);
//
// Results of a search are layers, each as large as the map:
//
//   wend::BitGrid cells(space.width(), space.height());
//   cells.set({1, 1}, true);
//   scene.marked = {{wend::CellRole::expanded, cells}};
//   scene.heatmap = {"order of expansion", wend::Grid<double>(space.width(), space.height(), 0)};
//
// A car stands on lattice vertices, with a heading:
//
//   wend::Scene yard{.space = space};
//   yard.path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
//   yard.start = yard.path.poses().front();
//   yard.places = wend::corners_of(space);
//
// The planned, smoothed and driven path are lines, each in its own colour:
//
//   scene.lines = {{wend::LineRole::planned, plan->path.points()},
//                  {wend::LineRole::smoothed, smoothed.points()}};
//
// In a cell, an obstacle covers roles, a role covers the heatmap, and the heatmap covers the map's
// other content. With a heatmap, rough ground looks like any other ground. Nothing outside the map
// is drawn. A Scene is a plain value; copies share the map, not the layers.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"
#include "wend/path/motion_tree.hpp"
#include "wend/path/path.hpp"
#include "wend/render/heatmap.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The role of a cell in a search, or in the explanation of its failure.
enum class CellRole : unsigned char {
  expanded,         // visited: closed, or on the walk
  frontier,         // generated and still open
  current,          // being expanded now
  start_component,  // can be reached from the start
  goal_component,   // the goal can be reached from it; no path joins the two components
};
inline constexpr std::size_t kCellRoles = 5;

/// The name in a legend: "frontier", "start's component".
std::string_view describe(CellRole role);

struct MarkedCells {
  CellRole role;
  BitGrid cells;  // as large as the map
};

/// The role of a line: the planned path, the smoothed path, the driven path, or a path that would
/// exist after a change (a smaller robot).
enum class LineRole : unsigned char { planned, smoothed, driven, possible };
inline constexpr std::size_t kLineRoles = 4;

/// The name in a legend: "planned".
std::string_view describe(LineRole role);

/// Straight lines through points in grid coordinates.
struct SceneLine {
  LineRole role;
  std::vector<Point> points;
  std::string label{};  // the name in the legend; empty: describe(role)
};

/// The direction to move from each cell. As large as the map.
using ArrowField = Grid<std::optional<Direction>>;

/// A start or a goal, in grid coordinates, some with a heading.
struct ScenePlace {
  Point point;
  std::optional<double> heading{};  // radians, from +x towards +y

  // NOLINTBEGIN(google-explicit-constructor): points and poses are places
  ScenePlace(Point place) : point(place) {}
  ScenePlace(const Pose& pose) : point(pose.point()), heading(pose.heading) {}
  // NOLINTEND(google-explicit-constructor)

  friend bool operator==(const ScenePlace&, const ScenePlace&) = default;
};

struct Scene {
  FreeSpace space;
  Path path{};                     // empty: not drawn
  std::vector<SceneLine> lines{};  // over the path, later ones over earlier ones
  std::optional<ScenePlace> start{};
  std::vector<ScenePlace> goals{};
  std::vector<MarkedCells> marked{};  // later ones over earlier ones
  std::optional<Heatmap> heatmap{};   // under the marked cells
  /// Numbers that pictures write into the cells above those of the heatmap, from the top, where cells are large enough.
  std::vector<Grid<double>> numbers_above{};
  /// Of a search over poses: drawn in the heatmap's colours by their order, from 1, and its cells are not. Text pictures
  /// show its cells.
  MotionTree motions{};
  std::optional<ArrowField> arrows{};  // under path and marks
  std::optional<Point> narrowest{};    // grid coordinates: the narrowest place of a passage
  std::vector<Cell> nearest_free{};    // free cells nearest to a blocked start or goal
  std::optional<Point> collision{};    // grid coordinates: where the robot collides
  std::optional<Pose> robot{};         // grid coordinates: where the robot is, drawn to scale
  PlaceGrid places{};                  // of the planner: a car stands on corners
};

/// The order of the drawn rows of a map: row 0 at the top, or at the bottom if the map has y up.
struct RowOrder {
  int rows = 1;
  bool y_up = false;

  /// The row that is drawn as the n-th from the top; also the drawn place of row n from the top.
  int row(int n) const { return y_up ? rows - 1 - n : n; }

  /// The distance of a grid coordinate from the top edge.
  double down(double y) const { return y_up ? rows - y : y; }

  /// A direction, or the one nearest to a heading, as drawn: where y grows downwards.
  Direction direction(Direction in_grid) const { return on_page(in_grid, {.y_up = y_up}); }
  Direction direction(double heading) const { return direction(nearest_direction(heading)); }
};

inline RowOrder row_order(const FreeSpace& space) {
  return {space.height(), space.map().frame().y_up};
}

/// The map with a start and a goal, at the centres of cells.
Scene scene_between(FreeSpace space, Cell start, Cell goal);

/// The map with a path (not empty) and marks at its ends; for a car's path, with headings and a
/// lattice resolution of one cell.
Scene scene_of(FreeSpace space, Path path);

/// The map with lines, the ends of the last one (not empty) marked.
Scene scene_of(FreeSpace space, std::vector<SceneLine> lines);

/// The cells that the robot may stand on: with some heading if the path or the motions have
/// headings, else with all.
const BitGrid& standable(const Scene& scene);

/// The role of a cell: that of the last layer that marks it.
std::optional<CellRole> role_of(const Scene& scene, Cell cell);

/// The roles of its layers, each once, in the enum's order.
std::vector<CellRole> roles_in(const Scene& scene);

}  // namespace wend
