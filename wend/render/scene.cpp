#include "wend/render/scene.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <ranges>

namespace wend {

std::string_view describe(CellRole role) {
  static constexpr std::array<std::string_view, kCellRoles> kNames{
      "expanded", "frontier", "being expanded", "start's component", "goal's component"};
  return kNames[static_cast<std::size_t>(role)];
}

std::string_view describe(LineRole role) {
  static constexpr std::array<std::string_view, kLineRoles> kNames{"planned", "smoothed", "driven",
                                                                   "possible path"};
  return kNames[static_cast<std::size_t>(role)];
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
  const auto mark_poses = [&](const JoinedPoses& joined) {
    scene.start = joined.poses().front();
    scene.goals = {joined.poses().back()};
    scene.places = corners_of(scene.space);
  };
  path.visit(mark_poses, [&](const auto&) {
    const std::vector<Point> points = path.points();
    scene.start = points.front();
    scene.goals = {points.back()};
  });
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

const BitGrid& standable(const Scene& scene) {
  const bool with_headings = scene.path.driven() || !scene.motions.empty();
  return with_headings ? scene.space.possible() : scene.space.passable();
}

std::optional<CellRole> role_of(const Scene& scene, Cell cell) {
  for (const MarkedCells& marked : scene.marked | std::views::reverse) {
    if (marked.cells[cell]) return marked.role;
  }
  return std::nullopt;
}

std::vector<CellRole> roles_in(const Scene& scene) {
  std::vector<CellRole> roles;
  for (std::size_t i = 0; i < kCellRoles; ++i) {
    const auto role = static_cast<CellRole>(i);
    const bool occurs = std::ranges::any_of(scene.marked, [&](const MarkedCells& marked) {
      return marked.role == role && marked.cells.count() > 0;
    });
    if (occurs) roles.push_back(role);
  }
  return roles;
}

}  // namespace wend
