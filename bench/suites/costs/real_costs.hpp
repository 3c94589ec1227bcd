#pragma once

// The yardstick of the suite costs: how cells with costs were searched before costs were whole numbers. A* with
// costs in doubles and a heap, without pruning, cell by cell; and Dijkstra's algorithm for all cells.

#include <memory>

#include "wend/map/grid.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

/// 8 neighbours, no corners cut, the octile estimate.
std::unique_ptr<GridEngine> real_cost_engine(const FreeSpace& space);

/// The cost of every cell to the goal, which is free, by Dijkstra's algorithm in the same way.
Grid<double> real_costs_to_go(const FreeSpace& space, Cell goal);

}  // namespace wend::bench
