#include "bench/suites/edits/next_query.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

std::vector<Query> random_queries(const FreeSpace& space, int count, std::uint64_t seed) {
  std::vector<Query> queries;
  for (const CellPair& cells : random_pairs(space, static_cast<std::uint64_t>(count), seed)) {
    queries.push_back(Query::between(cells.start, cells.goal));
  }
  return queries;
}

/// Toggles a random cell.
MapEdit toggle(Random& random, const GridMap& map) {
  const Cell cell{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
  const bool was_free = map.state(cell) == CellState::free;
  return {.cells = {{cell, was_free ? CellState::occupied : CellState::free}}};
}

/// Each on a space of its own.
double mean_first_query(const GridMap& map, const std::string& planner,
                        const std::vector<Query>& queries) {
  constexpr std::size_t kMost = 20;
  const std::size_t count = std::min(kMost, queries.size());
  double seconds = 0;
  Plan plan;
  for (std::size_t i = 0; i < count; ++i) {
    const FreeSpace space = *make_free_space(map);
    static_cast<void>(space.components());
    seconds += seconds_of(thread_cpu_seconds,
                          [&] { (*make_planner(planner, space))->plan(queries[i], plan); });
  }
  return seconds / static_cast<double>(count);
}

/// Asks all queries until a round takes hardly less time than the one before: then the planner has learned what it can.
double mean_learned_query(Planner& planner, const std::vector<Query>& queries) {
  constexpr int kMostRounds = 50;
  constexpr int kIdleRounds = 5;
  Plan plan;
  double least = 1e9;
  for (int round = 0, idle = 0; round < kMostRounds && idle < kIdleRounds; ++round, ++idle) {
    const double seconds = seconds_of(thread_cpu_seconds, [&] {
      for (const Query& query : queries) planner.plan(query, plan);
    });
    if (seconds < 0.98 * least) idle = 0;
    least = std::min(least, seconds);
  }
  return least / static_cast<double>(queries.size());
}

/// Compares some answers, not timed.
int count_wrong(const FreeSpace& space, Planner& planner, const std::string& name,
                const std::vector<Query>& queries) {
  constexpr std::size_t kMost = 10;
  const FreeSpace apart = *make_free_space(space.map());
  const auto fresh = *make_planner(name, apart);
  int wrong = 0;
  for (std::size_t i = 0; i < std::min(kMost, queries.size()); ++i) {
    Plan plan;
    Plan expected;
    const Status status = planner.plan(queries[i], plan);
    const bool equal = status == fresh->plan(queries[i], expected) &&
                       (status != Status::found || std::abs(plan.cost - expected.cost) < 1e-6);
    wrong += equal ? 0 : 1;
  }
  return wrong;
}

}  // namespace

NextQuery time_next_queries(std::string_view kind, int side, const std::string& planner, int count,
                            std::uint64_t seed) {
  std::optional<GridMap> map = generated_map(kind, side, side, {}, seed);
  FreeSpace space = *make_free_space(*map);
  const std::vector<Query> queries = random_queries(space, count, seed);
  const auto made = value_or_refuse(make_planner(planner, space));
  NextQuery row{.kind = std::string(kind), .side = side};
  row.first_one = mean_first_query(*map, planner, queries);
  row.unedited = mean_learned_query(*made, queries);
  map.reset();  // edits need not copy it then
  Random random(seed);
  Plan plan;
  for (int i = -1; i < count; ++i) {
    const MapEdit edit = toggle(random, space.map());
    const double edited = seconds_of(thread_cpu_seconds, [&] {
      made->release();
      const auto change = space.edit(edit);
      static_cast<void>(made->update(space, *change));
    });
    if (i < 0) continue;  // copies what the map shared before
    const double asked = seconds_of(
        thread_cpu_seconds, [&] { made->plan(queries[static_cast<std::size_t>(i)], plan); });
    row.edit += edited / count;
    row.next += asked / count;
    row.worst = std::max(row.worst, edited + asked);
  }
  row.wrong = count_wrong(space, *made, planner, queries);
  return row;
}

}  // namespace wend::bench
