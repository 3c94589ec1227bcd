#include "cli/output/no_path_scene.hpp"

#include <fmt/format.h>

#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/session/nearest_ends.hpp"

namespace wend::cli {
namespace {

/// Adds the cells that the robot can reach from any of `ends`.
void mark_components(Scene& scene, CellRole role, std::span<const Cell> ends, GridMoves moves) {
  for (const Cell end : ends) {
    if (scene.space.passable(end)) {
      scene.marked.push_back({role, component_of(scene.space, end, moves)});
    }
  }
}

/// If the robot cannot stand at an end, marks the nearest cell where it can.
void mark_nearest_free(Scene& scene, Cell end, Cell other, GridMoves moves) {
  if (!scene.space.contains(end) || scene.space.passable(end)) return;
  if (const auto cell = nearest_free(scene.space, end, other, moves.adjacency())) {
    scene.nearest_free.push_back(*cell);
  }
}

/// Draws the way that needs the fewest changes, and the place where it is too narrow now.
void add_way(Scene& scene, const Way& way, const Coordinates& coordinates) {
  const WidestPath& widest = way.widest;
  if (way.changes() == 0) {
    scene.path = widest.path;
    scene.narrowest = widest.narrowest;
    return;
  }
  scene.lines.push_back({LineRole::possible, widest.path.points(), describe(way, coordinates)});
  if (way.smaller_robot || way.squeeze) scene.narrowest = widest.narrowest;
}

/// Does way `a` need fewer changes than `b`, or as many and allow a larger robot?
bool is_easier(const Way& a, const Way& b) {
  if (a.changes() != b.changes()) return a.changes() < b.changes();
  return a.widest.radius > b.widest.radius;
}

/// The easiest way to any of the goals.
std::optional<Way> easiest_way(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                               GridMoves moves) {
  std::optional<Way> easiest;
  if (!space.contains(start)) return easiest;
  for (const Cell goal : goals) {
    if (!space.contains(goal)) continue;
    const NoPath why = explain_no_path(space, start, goal, moves);
    if (why.ways.empty()) continue;
    if (!easiest || is_easier(why.ways.front(), *easiest)) easiest = why.ways.front();
  }
  return easiest;
}

/// The scene without the way.
Scene components_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                       GridMoves moves) {
  Scene scene{.space = space};
  scene.start = centre_of(start);
  for (const Cell goal : goals) scene.goals.emplace_back(centre_of(goal));
  mark_components(scene, CellRole::goal_component, goals, moves);
  mark_components(scene, CellRole::start_component, {&start, 1}, moves);
  mark_nearest_free(scene, start, goals.front(), moves);
  for (const Cell goal : goals) mark_nearest_free(scene, goal, start, moves);
  return scene;
}

}  // namespace

std::string describe(const Way& way, const Coordinates& coordinates) {
  std::string text = "path";
  if (way.smaller_robot) {
    text += fmt::format(" for a robot of {}", coordinates.length(way.widest.radius));
  }
  if (way.unknown_free) text += " through unknown cells";
  if (way.squeeze) {
    text += way.unknown_free ? " and between touching obstacles" : " between touching obstacles";
  }
  return text;
}

Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const Coordinates& coordinates, const NoPath& why) {
  Scene scene = components_scene(space, start, {&goal, 1}, moves);
  if (!why.ways.empty()) add_way(scene, why.ways.front(), coordinates);
  return scene;
}

Scene no_path_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                    GridMoves moves, const Coordinates& coordinates) {
  Scene scene = components_scene(space, start, goals, moves);
  if (const auto way = easiest_way(space, start, goals, moves)) add_way(scene, *way, coordinates);
  return scene;
}

}  // namespace wend::cli
