#pragma once

// What rviz shows of maps and plans: obstacle cells red, rough cells yellow, path, start and goal.

#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "wend/geometry/frame.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/footprint.hpp"

namespace wend_ros {

/// Obstacle cells as one red marker, rough ones as one yellow. Those of a map with y down are turned
/// by pi about x within their frame, so that rviz, where that frame is turned too, lights them from
/// above; their points then have -y.
visualization_msgs::MarkerArray yard_markers(const wend::GridMap& map, const std::string& frame_id);

/// A path in grid coordinates, and where its map lies.
struct ShownPath {
  const wend::Path& path;
  const wend::Frame& frame;
  const std::string& frame_id;
};

/// The path as a line, its start and goal as arrows, and the outline of the robot at both, in their colours,
/// along the path and where it changes between ahead and reverse, with a chevron to its front (none of a point; see
/// wend::outline_poses). For an empty path: what deletes them.
visualization_msgs::MarkerArray path_markers(const ShownPath& shown,
                                             const wend::Footprint& footprint);

/// The cells in the order in which a search expanded them, from 1 to 98; 0 where it did not go. rviz's
/// colours for costmaps go from blue to red in that range, and 0 is transparent.
nav_msgs::OccupancyGrid heatmap_of(const std::vector<wend::Cell>& order, const wend::GridMap& map,
                                   const std::string& frame_id);

}  // namespace wend_ros
