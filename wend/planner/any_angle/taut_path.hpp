#pragma once

// What paths over the corners of Portals have in common: their waypoints, and what becomes of them for a robot that
// is not a point.

#include <cstdint>
#include <span>

#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/sight/portals.hpp"

namespace wend {

/// Does a path go straight on at b, from a to c? Exact for centres and vertices.
bool goes_straight_on(Point a, Point b, Point c);

/// Does the robot's disc fit along a path of waypoints? O(cells passed).
bool disc_fits_along_path(const FreeSpace& space, const Path& path, Adjacency adjacency);

/// Replaces `path` by one through the centres of the cells that the taut one by these corners passes, pulled taut for
/// the robot. False if the corners are not those of a free path.
bool write_pulled_trail(const FreeSpace& space, Adjacency adjacency, const Portals& portals,
                        Cell start, std::span<const std::uint32_t> corners, Cell goal, Path& path);

}  // namespace wend
