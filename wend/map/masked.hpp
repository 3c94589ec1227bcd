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
#include "wend/map/map_edit.hpp"

namespace wend {

/// The map under a mask. The cells that only the mask blocks become a zone (GridMap::zones()) with the name of the
/// mask's own zone there (load_mask() gives it the file's), so that messages can say what blocks a robot, and a
/// robot inside can be led out. Fails with invalid_map if the mask does not touch the map, if sizes differ that must
/// not, or if a product of multipliers is not finite. O(cells of the map and of the mask).
WEND_API Expected<GridMap, Error> masked(const GridMap& map, const GridMap& mask);

/// A mask on the grid of a map, to hold edits to it: what masked() would do to a free map of the same grid. More
/// masks can be laid over it. Fails as masked() does. O(cells of the map and of the mask).
WEND_API Expected<GridMap, Error> mask_on_grid_of(const GridMap& map, const GridMap& mask);

/// An edit of the map as an edit of the masked map: cells that the mask blocks stay blocked, and new costs are
/// multiplied. `mask` is from mask_on_grid_of(), and the edit fits its grid. O(cells of the edit).
///
///   const auto zones_here = wend::mask_on_grid_of(office, zones->map);
///   session.edit(wend::masked_edit(edit, *zones_here));
WEND_API MapEdit masked_edit(MapEdit edit, const GridMap& mask);

}  // namespace wend
