#include "wend/map/own_costs.hpp"

namespace wend {

Expected<GridMap, Error> with_terrain(const GridMap& map, Grid<double> terrain) {
  auto made = make_grid_map(map.occupied(), map.unknown(), map.frame(), std::move(terrain));
  if (!made) return made;
  for (const MapZone& zone : map.zones()) made->add_zone(zone);
  return made;
}

}  // namespace wend
