// Costs and masks of maps of the C interface.

#include <span>
#include <string>

#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/map/own_costs.hpp"

namespace wend::c {
namespace {

using MapOutcome = Expected<std::unique_ptr<wend_map>, Failure>;

MapOutcome object_of(Expected<GridMap, Error> map) {
  if (!map) return failed(std::move(map.error()));
  return std::make_unique<wend_map>(*std::move(map));
}

Frame frame_of(double resolution, const wend_pose* origin) {
  const wend_pose at = origin == nullptr ? wend_pose{0, 0, 0} : *origin;
  return {
      .resolution = resolution, .origin = {at.x, at.y, at.heading}, .y_up = true, .metric = true};
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_map_from_occupancy(const int8_t* values, size_t size, int32_t width,
                                    int32_t height, double resolution, const wend_pose* origin,
                                    int32_t occupied_from, double cost_factor, wend_map** map,
                                    wend_error* error) {
  return made("map", map, error, [&]() -> MapOutcome {
    if (values == nullptr) return refused("values is null");
    return object_of(wend::map_from_occupancy(std::span(values, size), width, height,
                                              frame_of(resolution, origin),
                                              {occupied_from, cost_factor}));
  });
}

wend_status wend_map_from_costmap(const uint8_t* costs, size_t size, int32_t width, int32_t height,
                                  double resolution, const wend_pose* origin, double cost_factor,
                                  wend_map** map, wend_error* error) {
  return made("map", map, error, [&]() -> MapOutcome {
    if (costs == nullptr) return refused("costs is null");
    return object_of(wend::map_from_costmap(std::span(costs, size), width, height,
                                            frame_of(resolution, origin), {cost_factor}));
  });
}

wend_status wend_mask_load(const char* mask, wend_map** map, wend_error* error) {
  return made("map", map, error, [&]() -> MapOutcome {
    if (mask == nullptr) return refused("mask is null");
    const auto spec = wend::parse_mask_spec(mask);
    if (!spec) return failed(spec.error());
    auto loaded = wend::load_mask(spec->file, spec->reading);
    if (!loaded) return failed(std::move(loaded.error()));
    return std::make_unique<wend_map>(std::move(loaded->map), std::move(loaded->notes));
  });
}

wend_status wend_map_masked(const wend_map* map, const wend_map* mask, wend_map** masked,
                            wend_error* error) {
  return made("masked", masked, error, [&]() -> MapOutcome {
    if (map == nullptr) return refused("map is null");
    if (mask == nullptr) return refused("mask is null");
    return object_of(wend::masked(map->map, mask->map));
  });
}

wend_status wend_map_with_terrain(const wend_map* map, const double* terrain, size_t count,
                                  wend_map** changed, wend_error* error) {
  return made("changed", changed, error, [&]() -> MapOutcome {
    if (map == nullptr) return refused("map is null");
    if (terrain == nullptr) return refused("terrain is null");
    if (count != map->map.size()) {
      return refused("there are " + std::to_string(count) + " terrain multipliers for " +
                     std::to_string(map->map.size()) + " cells");
    }
    return object_of(wend::with_terrain(
        map->map, {map->map.width(), map->map.height(), std::vector(terrain, terrain + count)}));
  });
}

wend_status wend_map_with_costs(const wend_map* map, wend_cost_function cost_of, void* context,
                                wend_map** changed, wend_error* error) {
  return made("changed", changed, error, [&]() -> MapOutcome {
    if (map == nullptr) return refused("map is null");
    if (cost_of == nullptr) return refused("cost_of is null");
    return object_of(wend::with_terrain(
        map->map, [&](wend::Cell cell) { return cost_of(cell.x, cell.y, context); }));
  });
}
