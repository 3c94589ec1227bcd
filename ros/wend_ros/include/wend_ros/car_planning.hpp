#pragma once

// CarPlanning: a yard and a drive on it, from message to message. Knows no node.
//
// Messages count corners, with +y south; so do the grid coordinates of the map made here, whose
// frame has y down. One cell is one metre in the frame `car_map`, which is `map` turned by pi
// about x.

#include <wend_ros/CarRequest.h>
#include <wend_ros/CarResult.h>

#include <string>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"
#include "wend_ros/planning.hpp"

namespace wend_ros {

/// The map of a request, or what is wrong with it, unsupported_query: "obstacles[3]: the cell (20,4) is outside the
/// map".
wend::Expected<wend::GridMap, wend::Error> yard_of(const CarRequest& request);

CarResult plan_car(const CarRequest& request, const Watch& watch = {});

/// A request for a yard: its map, of any kind that wend reads, with y down.
CarRequest request_for(const wend::GridMap& yard);

/// "Start (0,0,E)", then "Go FWD_RIGHT -> (2,1,S)", "Go 3 x FWD -> (2,4,S)": a line for equal moves in a row.
std::vector<std::string> commands_of(const CarResult& result);

/// The drive in the frame `car_map`.
wend::Path path_of(const CarResult& result);

}  // namespace wend_ros
