#include "wend/map/own_costs.hpp"

namespace wend {

Expected<GridMap, Error> with_terrain(const GridMap& map, Grid<double> terrain) {
  auto made = make_grid_map(map.occupied(), map.unknown(), map.frame(), std::move(terrain));
  if (made) made->take_masks_of(map);
  return made;
}

}  // namespace wend
