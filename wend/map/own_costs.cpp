#include "wend/map/own_costs.hpp"

namespace wend {

Expected<GridMap, Error> with_terrain(const GridMap& map, Grid<double> terrain) {
  return make_grid_map(map.occupied(), map.unknown(), map.frame(), std::move(terrain));
}

}  // namespace wend
