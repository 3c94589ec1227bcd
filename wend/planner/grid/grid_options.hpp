#pragma once

// The options of the planners that search on cells, as structs. Front ends set the same fields by name.
//
//   const auto planner = wend::make_planner(space, wend::AStarOptions{.weight = 2});

#include <cstdint>
#include <string_view>

#include "wend/base/options.hpp"
#include "wend/space/grid/grid_moves.hpp"
#include "wend/space/grid/heuristic.hpp"
#include "wend/space/grid/search_order.hpp"

namespace wend {

namespace detail {
template <class Leaps, class Field>
void leaps_field(Leaps& leaps, Field&& field) {
  field(
      {"leaps",
       "on maps with costs, skip cells that cannot matter, for speed; false: expand cell by cell"},
      leaps);
}
}  // namespace detail

/// The options of `astar`.
struct AStarOptions {
  static constexpr std::string_view kPlanner = "astar";  // its name

  GridMoves moves = {};             // how the robot steps
  HeuristicOptions heuristic = {};  // the estimate of the cost to the goal
  double weight = 1;                // w >= 0 in f = g + w h: 0 is Dijkstra
  bool leaps = true;       // on maps with costs; false: expand cell by cell, to watch a search
  SearchOrder order = {};  // of neighbours and of equal cells

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    HeuristicOptions::fields(self.heuristic, field);
    field({"weight",
           "w in f = g + w h: 0 is Dijkstra, 1 is A*; above 1 the cost is at most w times the "
           "optimum",
           {"lambda", "w"}},
          self.weight, OptionRange{0, 1e6});
    detail::leaps_field(self.leaps, field);
    SearchOrder::fields(self.order, field);
  }
};

/// The options of `greedy`.
struct GreedyOptions {
  static constexpr std::string_view kPlanner = "greedy";  // its name

  GridMoves moves = {};                                     // how the robot steps
  HeuristicOptions heuristic = {HeuristicKind::euclidean};  // the estimate of the cost to the goal
  SearchOrder order = {};                                   // of neighbours and of equal cells

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    HeuristicOptions::fields(self.heuristic, field);
    SearchOrder::fields(self.order, field);
  }
};

/// The options of `dijkstra`.
struct DijkstraOptions {
  static constexpr std::string_view kPlanner = "dijkstra";  // its name

  GridMoves moves = {};    // how the robot steps
  bool leaps = true;       // on maps with costs; false: expand cell by cell, to watch a search
  SearchOrder order = {};  // of neighbours and of equal cells

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    detail::leaps_field(self.leaps, field);
    SearchOrder::fields(self.order, field);
  }
};

/// The options of `alt`.
struct AltOptions {
  static constexpr std::string_view kPlanner = "alt";  // its name
  static constexpr double kMostLandmarks = 64;         // each takes 4 bytes a cell

  GridMoves moves = {};        // how the robot steps
  std::int64_t landmarks = 8;  // 1 to kMostLandmarks

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    field({"landmarks", "number of landmarks; each takes 4 bytes per cell"}, self.landmarks,
          OptionRange{1, kMostLandmarks});
  }
};

/// The options of `ara_star`.
struct AraStarOptions {
  static constexpr std::string_view kPlanner = "ara_star";  // its name

  GridMoves moves = {};       // how the robot steps
  double initial_weight = 3;  // of the estimate, until the first path; 1 is A*
  double weight_step = 0.5;   // what the next weight is below the bound that is proven
  bool leaps = true;          // false: expand cell by cell, to watch a search

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    field(
        {"initial_weight",
         "w in f = g + w h until the first path, which costs at most w times the optimum; 1 is A*"},
        self.initial_weight, OptionRange{1, 1e6});
    field({"weight_step", "what the next w is below the bound that is proven"}, self.weight_step,
          OptionRange{0.01, 1e6});
    field({"leaps", "skip cells that cannot matter, for speed; false: expand cell by cell"},
          self.leaps);
  }
};

/// The options of `bfs`.
struct BfsOptions {
  static constexpr std::string_view kPlanner = "bfs";  // its name

  GridMoves moves = {};                             // how the robot steps
  NeighbourOrder neighbours = NeighbourOrder::any;  // of a cell

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    detail::neighbour_order_field(self.neighbours, field);
  }
};

/// The options of `dfs`.
struct DfsOptions {
  static constexpr std::string_view kPlanner = "dfs";  // its name

  GridMoves moves = {};                             // how the robot steps
  NeighbourOrder neighbours = NeighbourOrder::any;  // of a cell

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    detail::neighbour_order_field(self.neighbours, field);
  }
};

/// The options of `random_walk`.
struct RandomWalkOptions {
  static constexpr std::string_view kPlanner = "random_walk";  // its name
  static constexpr double kMostSteps = 1e8;                    // a walk keeps 8 bytes a step

  std::int64_t max_steps = 1'000'000;  // 0 to kMostSteps
  std::int64_t seed = 1;               // at least 0: each seed gives another walk

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"max_steps",
           "limit on the number of steps; the walk avoids the cells of its last "
           "floor(sqrt(max_steps)) steps"},
          self.max_steps, OptionRange{0, kMostSteps});
    field({"seed", "seed of the random numbers: each seed gives another walk"}, self.seed,
          OptionRange{0, 9e15});
  }
};

}  // namespace wend
