#pragma once

// Makes the queries of a scenario for a map, as MovingAI's sets have them: in buckets by the length
// of the shortest path, ten in each, bucket = floor(length / 4).
//
// A random cell and Dijkstra's algorithm from it give the cost of every cell; one of the cells in
// each bucket becomes the other end of a query. That is repeated with other cells until the buckets
// are full, or hardly anything is left to find: the last buckets of a map may hold fewer queries.
//
//   const auto queries = wend::scenario_queries(space, {}, {.seed = 1, .buckets = 10});

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// Width of a bucket, in cells.
inline constexpr double kBucketLength = 4;

struct ScenarioPlan {
  std::uint64_t seed = 1;
  std::size_t buckets = std::numeric_limits<std::size_t>::max();  // at most, shortest paths first
  std::size_t per_bucket = 10;                                    // queries
};

/// Queries between different connected cells, each with the cost of a cheapest path, rounded
/// to 8 decimals, by bucket. The same arguments give the same queries on every platform. `map`,
/// `line` are left empty. Fails with the limit that was reached. O(per_bucket * cells * log cells).
Expected<std::vector<ScenarioQuery>, Status> scenario_queries(const FreeSpace& space,
                                                              GridMoves moves,
                                                              const ScenarioPlan& plan,
                                                              const Limits& limits = {});

}  // namespace wend
