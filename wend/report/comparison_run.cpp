#include "wend/report/comparison_run.hpp"

#include <cmath>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// The cells of each region by its label, in the order of the map; those of one cell have no pairs.
std::vector<std::vector<Cell>> regions_with_pairs(const FreeSpace& space) {
  const ConnectedRegions& regions = space.regions();
  std::vector<std::vector<Cell>> cells(regions.count(Adjacency::edges) + 1);
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      const Cell cell{x, y};
      if (regions.size_of_region(cell, Adjacency::edges) < 2) continue;
      cells[regions.region(cell, Adjacency::edges)].push_back(cell);
    }
  }
  return cells;
}

/// Whole eighths of a turn come out as whole degrees.
double without_rounding(double degrees) {
  constexpr double kDigits = 1e6;
  return std::round(degrees * kDigits) / kDigits;
}

}  // namespace

std::vector<CellPair> random_pairs(const FreeSpace& space, std::uint64_t count,
                                   std::uint64_t seed) {
  const std::vector<std::vector<Cell>> regions = regions_with_pairs(space);
  std::vector<Cell> starts;
  for (const auto& region : regions) starts.insert(starts.end(), region.begin(), region.end());
  std::vector<CellPair> pairs;
  if (starts.empty()) return pairs;
  Random random(seed);
  pairs.reserve(count);
  while (pairs.size() < count) {
    const Cell start = starts[random.below(starts.size())];
    const auto& region = regions[space.regions().region(start, Adjacency::edges)];
    const Cell goal = region[random.below(region.size())];
    if (goal != start) pairs.push_back({start, goal});
  }
  return pairs;
}

Expected<ComparisonRun, PlannerError> ComparisonRun::make(const FreeSpace& space,
                                                          std::vector<PlannerSpec> specs,
                                                          Clock clock) {
  ComparisonRun run(space, std::move(clock));
  run.comparison_.frame = space.map().frame();
  for (PlannerSpec& spec : specs) {
    auto planner = make_planner(spec.name, space, spec.options);
    if (!planner && planner.error().status == Status::invalid_option) {
      return Unexpected<PlannerError>(
          {Status::invalid_option, spec.text + ": " + planner.error().message()});
    }
    run.errors_.push_back(planner ? PlannerError{} : planner.error());
    run.planners_.push_back(planner ? *std::move(planner) : nullptr);
    run.specs_.push_back(std::move(spec));
  }
  return run;
}

void ComparisonRun::answer(const CellPair& cells, const Limits& limits) {
  ComparedQuery query{cells.start, cells.goal, {}};
  for (std::size_t planner = 0; planner < specs_.size(); ++planner) {
    query.rows.push_back(answer_of(planner, cells, limits));
  }
  comparison_.queries.push_back(std::move(query));
}

ComparisonRow ComparisonRun::answer_of(std::size_t planner, const CellPair& cells,
                                       const Limits& limits) {
  ComparisonRow row{.planner = specs_[planner].text};
  Planner* const made = planners_[planner].get();
  if (made == nullptr) {
    row.status = errors_[planner].status;
    row.reason = errors_[planner].what;
    return row;
  }
  Query query = Query::between(cells.start, cells.goal);
  query.limits = limits;
  if (comparison_.queries.empty()) made->plan(query, plan_);
  const double begin = clock_();
  row.status = made->plan(query, plan_);
  row.seconds = clock_() - begin;
  row.cost = plan_.cost;
  row.expanded = plan_.metrics.expanded;
  row.generated = plan_.metrics.generated;
  row.max_frontier = plan_.metrics.max_frontier;
  if (!row.found()) return row;
  const PathMetrics metrics = measure(plan_.path, space_);
  row.length = metrics.length;
  row.turning = without_rounding(degrees_from(metrics.turning));
  row.smallest_clearance = metrics.smallest_clearance;
  return row;
}

/// Runs a search again as far as it went: one that was stopped by the clock may go no further.
Plan ComparisonRun::again(std::size_t planner, std::size_t query, SearchObserver* observer) const {
  const ComparedQuery& asked = comparison_.queries[query];
  Query same = Query::between(asked.start, asked.goal);
  same.limits.expansions = asked.rows[planner].expanded;
  same.observer = observer;
  Plan plan;
  if (planners_[planner] != nullptr) planners_[planner]->plan(same, plan);
  return plan;
}

SearchRecorder ComparisonRun::record(std::size_t planner, std::size_t query) const {
  SearchRecorder recorder(space_);
  again(planner, query, &recorder);
  return recorder;
}

Path ComparisonRun::path(std::size_t planner, std::size_t query) const {
  return again(planner, query, nullptr).path;
}

}  // namespace wend
