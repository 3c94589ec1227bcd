#pragma once

// Why there is no path, as a scene: components, the nearest free cells, and the way that a change would open.

#include <span>
#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/render/scene.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

/// The scene of a start and its goals, one or more; those outside the map are left out.
Scene no_path_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                    GridMoves moves, const Coordinates& coordinates);

/// The same for one goal and a known reason. Start and goal must be on the map.
Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const Coordinates& coordinates, const NoPath& why);

/// What a path needs: "path for a robot of 0.45 m through unknown cells".
std::string describe(const Way& way, const Coordinates& coordinates);

}  // namespace wend::cli
