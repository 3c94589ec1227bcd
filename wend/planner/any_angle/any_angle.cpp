// The shortest path at any angle: A* on the corners of a map, of which it keeps what it has looked up. Lines of sight
// through rows as in D. Harabor, A. Grastien, D. Oz and V. Aksakalli, "Optimal Any-Angle Pathfinding In Practice",
// 2016; taut edges as in S. Oh and H. W. Leong, "Edge N-Level Sparse Visibility Graphs", 2017.

#include <utility>

#include "wend/planner/any_angle/any_angle_options.hpp"
#include "wend/planner/any_angle/prepared_sight.hpp"
#include "wend/planner/any_angle/taut_engine.hpp"
#include "wend/planner/grid/grid_planner.hpp"

namespace wend {
namespace {

GridPlanner::Parts choose_parts(const FreeSpace& space, const ShortestAnyAngleOptions& options,
                                DeadlineCheck& stop) {
  const GridMoves moves{Connectivity::eight, options.corner_rule};
  // The robot's own disc decides how near it may come; only a point's shortest path is known.
  const double bound = space.is_point() ? 1 : Plan::kNoBound;
  if (!space.uniform_terrain()) return {moves, nullptr, bound, true};
  const Adjacency adjacency = moves.adjacency();
  auto prepared = PreparedSight::of(space);
  // The engine asks for them again.
  if (prepared->portals(space, adjacency, stop) == nullptr) return {};
  return {moves, std::make_unique<TautEngine>(space, adjacency, std::move(prepared)), bound, true};
}

}  // namespace

PlannerInfo any_angle_planner() {
  return grid_planner<ShortestAnyAngleOptions>(
      {.name = "any_angle",
       .summary = "The shortest path at any angle",
       .idea =
           "A shortest path is straight but for corners of obstacles, around which it bends. A* "
           "goes from corner to corner, along lines that touch both obstacles, and turns only "
           "towards them. What a corner sees is found row by row in whole numbers, and kept. After "
           "some queries it prepares the whole map, for all any_angle planners on the same free "
           "space: what each corner sees, and by which cells it is seen.",
       .citation = "Harabor and others 2016; Oh, Leong 2017",
       .guarantee_text =
           "optimal for a point on uniform terrain: no path at any angle between the points of the "
           "query is shorter; for a disc or a polygon complete, and every path is free",
       .time = "O(n log n) in the n corners reached, and the rows seen from those that no search "
               "has expanded before; on a prepared map without these rows",
       .memory =
           "16 bytes per run of free cells in a row, 24 per opening between two of them; per "
           "corner of an obstacle 93, and 24 per corner that it sees; on a prepared map also "
           "12 per corner and block of 8 x 8 cells that sees it, at most 64 per cell and 1 MiB "
           "in all, or the map is not prepared",
       .when = "Where the shortest path counts, and for measuring how much longer others are. It "
               "refuses terrain and clearance costs. Paths touch corners of obstacles: give the "
               "robot a radius if it needs distance.",
       .guarantee = Guarantee::complete,
       .capabilities = {.any_angle = true, .jumps = true, .learns = true}},
      choose_parts);
}

}  // namespace wend
