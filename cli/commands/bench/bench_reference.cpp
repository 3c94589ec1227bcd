#include "cli/commands/bench/bench_reference.hpp"

#include <limits>

#include "cli/exit_code.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {
namespace {

constexpr int kDecimals = 8;

/// The options of a planner that moves so.
OptionValues options_of(GridMoves moves) {
  OptionValues values;
  for (const auto& choice : choice_names(Connectivity{})) {
    if (choice.value == moves.connectivity) values.emplace_back("connectivity", choice.name);
  }
  for (const auto& choice : choice_names(CornerRule{})) {
    if (choice.value == moves.corner_rule) values.emplace_back("corner_rule", choice.name);
  }
  return values;
}

}  // namespace

void set_lengths(std::vector<ScenarioQuery>& queries, const FreeSpace& space, GridMoves moves) {
  const auto planner = make_planner("dijkstra", space, options_of(moves));
  if (!planner) throw InputError(planner.error().message());
  ProgressBar bar("lengths", queries.size());
  Plan plan;
  std::uint64_t done = 0;
  for (ScenarioQuery& query : queries) {
    const Status status = (*planner)->plan(Query::between(query.start, query.goal), plan);
    query.length = status == Status::found ? plan.cost : std::numeric_limits<double>::infinity();
    query.decimals = kDecimals;
    bar.update(++done);
  }
}

}  // namespace wend::cli
