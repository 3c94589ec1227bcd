#include "docs/planner_page/clearance_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "bench/measure/statistics.hpp"
#include "docs/planner_page/markdown.hpp"
#include "docs/planner_page/measured_family.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend::planner_page {
namespace {

constexpr std::array kDistances{0.0, 0.25, 0.5, 1.0};  // metres
constexpr double kRobotRadius = 0.2;
constexpr std::uint64_t kSeed = 7;

/// One value a query.
struct Answers {
  std::vector<double> lengths;
  std::vector<double> mean_clearances;
  std::vector<double> least_clearances;
  std::vector<double> expanded;
  std::vector<double> us;
};

Answers answers(const FreeSpace& space, const std::vector<CellPair>& queries, Effort effort) {
  auto run = ComparisonRun::make(space, *parse_planner_specs("astar"), thread_cpu_seconds,
                                 repetition(effort));
  assert(run);
  const double resolution = space.map().frame().resolution;
  Answers all;
  for (const CellPair& query : queries) {
    const std::size_t number = run->comparison().queries.size();
    run->answer(query);
    const ComparisonRow& row = run->comparison().queries.back().rows.front();
    const PathMetrics metrics = measure(run->path(0, number), space);
    all.lengths.push_back(metrics.length);
    all.mean_clearances.push_back(metrics.mean_clearance * resolution);
    all.least_clearances.push_back(metrics.smallest_clearance * resolution);
    all.expanded.push_back(static_cast<double>(row.expanded));
    all.us.push_back(row.times.later * 1e6);
  }
  return all;
}

double median(std::vector<double> values) { return summary_of(std::move(values)).median; }

double median_ratio(const std::vector<double>& values, const std::vector<double>& to) {
  std::vector<double> ratios;
  ratios.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) ratios.push_back(values[i] / to[i]);
  return median(std::move(ratios));
}

}  // namespace

ClearanceCostStudy study_clearance_distance(Effort effort) {
  const bool quick = effort == Effort::quick;
  const GridMap map = generated_map("office", quick ? 160 : 600, quick ? 100 : 400, kSeed);
  const FreeSpace plain(map, {.robot_radius = kRobotRadius});
  const std::vector<CellPair> queries = random_pairs(plain, quick ? 3 : 200, kSeed);
  ClearanceCostStudy study;
  study.about = fmt::format(
      "`astar` for a disc of {} m in an office of {:.0f} x {:.0f} m, {} random queries. A cell "
      "where the disc touches an obstacle costs 5 times as much, and less and less out to the "
      "distance.",
      kRobotRadius, map.width() * map.frame().resolution, map.height() * map.frame().resolution,
      queries.size());
  std::vector<double> plain_lengths;
  for (const double distance : kDistances) {
    const FreeSpace space(map, {.robot_radius = kRobotRadius, .clearance_distance = distance});
    const Answers all = answers(space, queries, effort);
    if (plain_lengths.empty()) plain_lengths = all.lengths;
    study.rows.push_back({distance, median_ratio(all.lengths, plain_lengths),
                          median(all.mean_clearances), median(all.least_clearances),
                          median(all.expanded), median(all.us)});
  }
  return study;
}

std::string clearance_distance_table(const ClearanceCostStudy& study) {
  MarkdownTable table({{"keep away, m", Align::right},
                       {"length / shortest", Align::right},
                       {"mean clearance, m", Align::right},
                       {"smallest clearance, m", Align::right},
                       {"expanded", Align::right},
                       {"time, µs", Align::right}});
  for (const ClearanceCostRow& row : study.rows) {
    table.add({number(row.clearance_distance, 2), number(row.longer, 3), number(row.clearance, 2),
               number(row.least_clearance, 2), number(row.expanded, 0), number(row.us, 1)});
  }
  return table.text();
}

}  // namespace wend::planner_page
