#include "wend/render/scene.hpp"

#include <algorithm>
#include <ranges>

namespace wend {

std::string_view describe(CellRole role) {
  switch (role) {
    case CellRole::expanded:
      return "expanded";
    case CellRole::frontier:
      return "frontier";
    case CellRole::current:
      return "being expanded";
    case CellRole::start_region:
      return "start's region";
    case CellRole::goal_region:
      return "goal's region";
  }
  return "";
}

std::optional<CellRole> role_of(const Scene& scene, Cell cell) {
  for (const MarkedCells& marked : scene.marked | std::views::reverse) {
    if (marked.cells[cell]) return marked.role;
  }
  return std::nullopt;
}

std::vector<CellRole> roles_in(const Scene& scene) {
  std::vector<CellRole> roles;
  for (const MarkedCells& marked : scene.marked) {
    if (marked.cells.count() > 0) roles.push_back(marked.role);
  }
  std::ranges::sort(roles);
  const auto repeated = std::ranges::unique(roles);
  roles.erase(repeated.begin(), repeated.end());
  return roles;
}

}  // namespace wend
