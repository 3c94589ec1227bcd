#include "wend/render/scene.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

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

Scene scene_between(FreeSpace space, Cell start, Cell goal) {
  Scene scene{.space = std::move(space)};
  scene.start = centre_of(start);
  scene.goals = {centre_of(goal)};
  return scene;
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
