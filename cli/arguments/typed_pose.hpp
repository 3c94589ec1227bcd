#pragma once

// Poses as people type them, for a car: X,Y,HEADING.
//
//   0,0,E         a corner, facing east: N, W, E and S are those of the map as drawn
//   0,0,2         the same: N = 0, W = 1, E = 2, S = 3
//   1.5,2,45deg   an angle in the map's frame, from +x towards +y; 0.8rad too
//   18,18,any     of a goal: whatever the heading; 18,18 too

#include <optional>
#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/planner/plan.hpp"
#include "wend/render/scene.hpp"

namespace wend::cli {

struct TypedPose {
  Point point;                    // grid coordinates; may lie outside the map
  std::optional<double> heading;  // radians, in grid coordinates; nothing: any
  std::string text;               // "(0,0,E)", "(1.5,2,45deg) m"

  Goal goal() const;

  /// For a picture.
  ScenePlace place() const;
};

/// The start of a car, which has a heading. Throws InputError for any other text.
TypedPose parse_start_pose(const Coordinates& coordinates, const std::string& typed);

/// A goal of a car. Throws InputError for any other text.
TypedPose parse_goal_pose(const Coordinates& coordinates, const std::string& typed);

}  // namespace wend::cli
