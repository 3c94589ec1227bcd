#pragma once

// The picture of a query that has no path, as `wend explain` shows it and `wend plan` writes it: what
// can be reached from the start, from where the goal can be reached, what is in the way between
// them, and the path that there would be if the least changed, dashed.

#include <optional>
#include <span>
#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/map/free_space.hpp"
#include "wend/render/scene.hpp"

namespace wend::cli {

/// The nearest cell where the robot may stand instead of a blocked one; where the robot may stand at
/// `other`, only cells that are connected to that.
std::optional<Cell> nearest_free(const FreeSpace& space, Cell cell, Cell other, GridMoves moves);

/// Of a start and its goals, one or more; those outside the map are left out.
Scene no_path_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                    GridMoves moves, const Coordinates& coordinates);

/// The same, of one goal, both ends on the map, where it has been found out why there is no path.
Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const Coordinates& coordinates, const NoPath& why);

/// What a way needs: "path for a robot of 0.45 m through unknown cells".
std::string describe(const Way& way, const Coordinates& coordinates);

}  // namespace wend::cli
