#include "docs/planner_page/page.hpp"

#include <fmt/format.h>

#include "bench/measure/machine.hpp"
#include "docs/planner_page/findings.hpp"
#include "docs/planner_page/registry_part.hpp"
#include "docs/planner_page/tables.hpp"

namespace wend::planner_page {
namespace {

constexpr std::string_view kIntroduction =
    "# Planners\n"
    "\n"
    "What each planner is, what it guarantees and costs, when to take it, and how they do on the "
    "same questions. `./run docs` writes this page: the first half from the registry of "
    "planners, the second from measurements. Do not edit it by hand.\n";

std::string how_it_was_measured(const Measurements& measurements) {
  std::string text = fmt::format(
      "Times are {} of one thread, from one run on one machine ({}): ratios mean more. The "
      "planners take turns, query by query. They are made before, and each query is asked as "
      "often as fills 5 ms; the quickest answer counts, which uses what a planner keeps (`jps` "
      "does) of those before. Values are medians over "
      "the queries that every planner of the table solved. *Cost / cheapest* is over the "
      "cheapest path that any planner of the table found, *worst* the greatest of these. "
      "*Clearance* is the smallest along the path. The best of a column is **bold**.\n",
      thread_time_name(), describe_machine());
  text += measurements.with_data
              ? "\nMaps are made by `wend generate`, seed 7, or come from the benchmark sets of "
                "movingai.com (N. Sturtevant, \"Benchmarks for Grid-Based Pathfinding\", 2012), "
                "named in brackets.\n"
              : "\nMaps are made by `wend generate`, seed 7.\n";
  return text;
}

std::string section(const std::string& title, const std::string& about, const std::string& table) {
  return fmt::format("\n### {}\n\n{}\n\n{}", title, about, table);
}

std::string numbers(const Measurements& measurements) {
  std::string text;
  for (const MeasuredFamily& family : measurements.families) {
    text += section(family.title, family.about, family_table(family));
  }
  const MeasuredFamily& small = measurements.small;
  text += section(small.title, small.about, family_table(small));
  const MeasuredFamily& no_path = measurements.no_path;
  text += section(no_path.title, no_path.about, no_path_table(no_path));
  text += section("Keeping away", measurements.clearance_distance.about,
                  clearance_distance_table(measurements.clearance_distance));
  text += section("Driving", measurements.drives.about, drive_tables(measurements.drives));
  return text;
}

}  // namespace

std::string page(std::span<const Picture> pictures, const Measurements& measurements) {
  return fmt::format(
      "{}\n{}\n\n{}\n{}\n\n"
      "## Measured\n\n{}\n"
      "Time over that of `astar` (less is faster; the fastest is bold). `astar:weight=2` may find "
      "a path "
      "of up to twice the cost, `astar:heuristic=euclidean` has a poorer estimate:\n\n{}\n"
      "On how many of these {} maps each was the best:\n\n{}\n"
      "## Which wins where, and why\n\n{}\n"
      "## The numbers\n{}",
      kIntroduction, kRegistryBegins, registry_part(pictures), kRegistryEnds,
      how_it_was_measured(measurements), overview_table(measurements.families),
      measurements.families.size(), wins_table(measurements.families), findings(measurements),
      numbers(measurements));
}

}  // namespace wend::planner_page
