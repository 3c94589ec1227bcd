#pragma once

// The picture of why no path joins two cells, as `wend explain` and a failed `wend plan` draw it.

#include "wend/planner/no_path.hpp"
#include "wend/render/scene.hpp"

namespace wend::cli {

/// What can be reached from the start, from where the goal can be, and the way that would need the
/// least changes with its narrowest place. Both cells are on the map; `why` is about them.
Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const NoPath& why);

}  // namespace wend::cli
