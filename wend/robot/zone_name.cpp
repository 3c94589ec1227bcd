#include "wend/robot/zone_name.hpp"

namespace wend {

std::optional<std::string> mask_that_blocks(const FreeSpace& space, Cell cell) {
  if (!space.contains(cell)) return std::nullopt;
  const MapZone* const zone = space.map().zone(cell);
  if (zone == nullptr) return std::nullopt;
  return zone->name.empty() ? "a keep-out mask" : "the keep-out mask '" + zone->name + "'";
}

}  // namespace wend
