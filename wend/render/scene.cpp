#include "wend/render/scene.hpp"

#include <algorithm>
#include <cassert>
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
    case CellRole::start_component:
      return "start's region";
    case CellRole::goal_component:
      return "goal's region";
  }
  return "";
}

std::string_view describe(LineRole role) {
  switch (role) {
    case LineRole::planned:
      return "planned";
    case LineRole::smoothed:
      return "smoothed";
    case LineRole::driven:
      return "driven";
    case LineRole::possible:
      return "possible path";
  }
  return "";
}

std::string label_of(const SceneLine& line) {
  return line.label.empty() ? std::string(describe(line.role)) : line.label;
}

Scene scene_between(FreeSpace space, Cell start, Cell goal) {
  Scene scene{.space = std::move(space)};
  scene.start = centre_of(start);
  scene.goals = {centre_of(goal)};
  return scene;
}

Scene scene_of(FreeSpace space, Path path) {
  assert(!path.empty());
  Scene scene{.space = std::move(space)};
  const std::vector<Pose> poses = path.poses();
  if (path.driven()) {
    scene.start = poses.front();
    scene.goals = {poses.back()};
    scene.unit = 1;
  } else {
    scene.start = poses.front().point();
    scene.goals = {poses.back().point()};
  }
  scene.path = std::move(path);
  return scene;
}

Scene scene_of(FreeSpace space, std::vector<SceneLine> lines) {
  assert(!lines.empty() && !lines.back().points.empty());
  Scene scene{.space = std::move(space)};
  scene.start = lines.back().points.front();
  scene.goals = {lines.back().points.back()};
  scene.lines = std::move(lines);
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
