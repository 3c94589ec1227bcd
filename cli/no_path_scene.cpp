#include "no_path_scene.hpp"

namespace wend::cli {

Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const NoPath& why) {
  Scene scene = scene_between(space, start, goal);
  scene.marked = {{CellRole::start_region, region_of(space, start, moves)}};
  if (!why.path_exists()) {
    scene.marked.push_back({CellRole::goal_region, region_of(space, goal, moves)});
  }
  // The way that asks for the least, or, where the robot fits, the widest one.
  if (!why.ways.empty()) {
    const WidestPath& widest = why.ways.front().widest;
    scene.path = widest.path;
    scene.narrowest = widest.narrowest;
  }
  return scene;
}

}  // namespace wend::cli
