#include "wend/robot/zone_name.hpp"

namespace wend {

std::optional<std::string> mask_at(const FreeSpace& space, Cell cell) {
  const MapZone* const zone = space.contains(cell) ? space.map().zone(cell) : nullptr;
  if (zone == nullptr) return std::nullopt;
  return zone->name;
}

std::string mask_text(const std::string& name) {
  return name.empty() ? "a keep-out mask" : "the keep-out mask '" + name + "'";
}

}  // namespace wend
