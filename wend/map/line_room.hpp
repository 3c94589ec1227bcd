#pragma once

// How much room there is beside a line that a robot drives: what lets a smoother move points again and
// again without looking at the map.

#include <optional>

#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// No line is asked for more, in cells.
inline constexpr double kMostRoom = 1;

/// A distance, in cells, by which both ends of the line may move, each its own way, and the robot
/// still drives along it: the swept clearance beyond the robot's radius, up to kMostRoom; 0 where it
/// touches. It may be less than that where it is at least half of kMostRoom. Nothing if the line is
/// not free by fits_along(), or ends in a gap between two obstacles (in_gap()), where it depends on
/// the lines before and after it whether they are. O(1) where the clearance of a cell decides, else
/// O(cells within the radius and kMostRoom), for each length.
std::optional<double> room_along(const FreeSpace& space, const Line& line,
                                 Adjacency adjacency = Adjacency::edges);

}  // namespace wend
