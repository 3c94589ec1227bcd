#pragma once

// Masks: maps that are laid over another one. An occupied cell of a mask is a keep-out zone, which blocks the
// map; a free one multiplies the cost of a unit of length by its own multiplier; an unknown one says nothing.
// Zones block the robot's whole shape, as every obstacle does. Masks can be laid one after another, in any order.
//
// The grids may differ. If both are in metres, frames say where they lie, and the mask may cover a part of the
// map. A cell takes what the mask has at its middle, and where the mask is finer, the worst of the cells whose
// middles lie in it: blocked, else the greatest multiplier. If one of the two has no resolution, or the y axes
// differ (Frame::y_up), both must have the same size, and lie on each other as they are drawn.
//
//   const auto zones = wend::load_mask("keepout.yaml");
//   if (!zones) return report(zones.error().message);
//   const auto map = wend::masked(office, zones->map);

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The map under a mask. Fails with invalid_map if the mask does not touch the map, if sizes differ that must
/// not, or if a product of multipliers is not finite. O(cells of the map and of the mask).
WEND_API Expected<GridMap, Error> masked(const GridMap& map, const GridMap& mask);

}  // namespace wend
