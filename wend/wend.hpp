#pragma once

// All that a program needs that loads a map, plans, refines a path and follows it.
// examples/ has a small program for each of these.

#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/map/own_costs.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/nearest_passable.hpp"
#include "wend/session/session.hpp"
#include "wend/version.hpp"

/// @namespace wend
/// All public classes and functions.
