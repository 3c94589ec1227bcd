#include "docs/planner_page/clearance_cost.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <utility>

#include "bench/comparison/comparison_run.hpp"
#include "bench/measure/markdown_table.hpp"
#include "bench/measure/statistics.hpp"
#include "docs/planner_page/measurements.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend::planner_page {
namespace {

constexpr std::array kDistances{0.0, 0.25, 0.5, 1.0};  // metres
constexpr double kRobotRadius = 0.2;
constexpr std::uint64_t kOfficeSeed = 7;

/// One value a query, lengths in metres.
struct OfficeAnswers {
  std::vector<double> lengths;
  std::vector<double> mean_clearances;
  std::vector<double> smallest_clearances;
  std::vector<double> expanded;
  std::vector<double> us;
};

OfficeAnswers answers_in(const FreeSpace& space, const std::vector<CellPair>& queries,
                         Effort effort) {
  auto run = ComparisonRun::make(space, *parse_planner_specs("astar"), thread_cpu_seconds,
                                 repetition(effort));
  assert(run);
  const double resolution = space.map().frame().resolution;
  OfficeAnswers all;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    run->answer(queries[i]);
    const ComparisonRow& row = run->comparison().queries.back().rows.front();
    const auto measured = measure(run->path(0, i), space);
    assert(measured);
    const PathMetrics& metrics = *measured;
    all.lengths.push_back(metrics.length * resolution);
    all.mean_clearances.push_back(metrics.mean_clearance * resolution);
    all.smallest_clearances.push_back(metrics.smallest_clearance * resolution);
    all.expanded.push_back(static_cast<double>(row.expanded));
    all.us.push_back(row.times.later * 1e6);
  }
  return all;
}

}  // namespace

std::string clearance_cost_section(Effort effort) {
  const bool quick = effort == Effort::quick;
  const GridMap map = generated_map("office", quick ? 160 : 600, quick ? 100 : 400, kOfficeSeed);
  const std::vector<CellPair> queries =
      random_pairs(*make_free_space(map, {.footprint = Footprint::disc(kRobotRadius)}),
                   quick ? 3 : 200, kOfficeSeed);
  MarkdownTable table({{"clearance distance, m", Align::right},
                       {"length / shortest", Align::right},
                       {"mean clearance, m", Align::right},
                       {"smallest clearance, m", Align::right},
                       {"expanded", Align::right},
                       {"time, µs", Align::right}});
  const auto median = [](const std::vector<double>& values, int decimals) {
    return decimal(summary_of(values).median, decimals);
  };
  std::vector<double> shortest;
  for (const double distance : kDistances) {
    const FreeSpace space = *make_free_space(
        map, {.footprint = Footprint::disc(kRobotRadius), .clearance_distance = distance});
    OfficeAnswers all = answers_in(space, queries, effort);
    if (shortest.empty()) shortest = all.lengths;
    for (std::size_t i = 0; i < shortest.size(); ++i) all.lengths[i] /= shortest[i];
    table.add({decimal(distance, 2), median(all.lengths, 3), median(all.mean_clearances, 2),
               median(all.smallest_clearances, 2), median(all.expanded, 0), median(all.us, 1)});
  }
  const double resolution = map.frame().resolution;
  return fmt::format(
      "`astar` for a disc of {} m in an office of {:.0f} x {:.0f} m, {} random queries. A cell "
      "where the disc touches an obstacle costs 5 times as much; the factor falls to 1 at the "
      "clearance distance.\n\n{}",
      kRobotRadius, map.width() * resolution, map.height() * resolution, queries.size(),
      table.text());
}

}  // namespace wend::planner_page
