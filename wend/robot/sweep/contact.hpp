#pragma once

// Contact: what a robot's polygon overlaps at a pose: an obstacle or the map's edge, and with which corner or side.

#include <cstddef>
#include <optional>
#include <string>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// One place at which the robot does not fit.
struct Contact {
  std::optional<Cell> obstacle;  // nothing: the map's edge
  std::optional<std::size_t>
      corner;  // of the outline, that lies in the obstacle or outside the map
  std::optional<std::size_t>
      side;  // else from this corner to the next one: it crosses the obstacle
};  // neither: the robot covers the whole obstacle

/// The contact of the first corner that touches anything; else that of the first obstacle, by rows. Nothing if the
/// robot is not a polygon, or fits. The pose is finite.
std::optional<Contact> contact_at(const FreeSpace& space, const Pose& pose);

/// "front left corner" of an outline with one corner in each quadrant around the base point; else
/// "corner (0.4,0.25)", in the coordinates of the outline. Left is as the map is drawn.
std::string corner_name(const Polygon& outline, std::size_t corner, const Frame& frame);

/// "its front left corner lies in the obstacle cell (3,4)"
std::string describe(const Contact& contact, const FreeSpace& space);

}  // namespace wend
