#include "docs/planner_page/situation_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "docs/planner_page/markdown.hpp"
#include "docs/planner_page/ratios.hpp"
#include "wend/planner/planners.hpp"

namespace wend::planner_page {
namespace {

using Families = std::span<const MeasuredFamily>;
using Row = MeasuredPlanner;

std::string on_four_neighbours(const MeasuredFamily& family) {
  const Row& bfs = *family.find("bfs");
  const Row& dijkstra = *family.find("dijkstra");
  std::string text = "**On 4 neighbours all steps cost the same**, ";
  if (bfs.always_cheapest()) text += "so the fewest of them are the cheapest path: ";
  text += fmt::format(
      "`bfs` paths cost {} times the cheapest on *{}*, in {} times the time of "
      "`dijkstra` and {} times that of `astar`.",
      factor(bfs.cost), family.title, factor(bfs.us / dijkstra.us), factor(bfs.us_of_astar));
  return text;
}

bool plans_on_terrain(const Row& row) {
  const std::string name = row.role.substr(0, row.role.find(':'));
  return planners().find(name)->plans_on_terrain;
}

std::string on_terrain(const MeasuredFamily& family, Families plain) {
  std::vector<std::string> blind;
  double least_cost = 0;
  double worst_cost = 0;
  for (const Row& row : family.planners) {
    if (plans_on_terrain(row)) continue;
    blind.push_back(code(row.role));
    least_cost = blind.size() == 1 ? row.cost : std::min(least_cost, row.cost);
    worst_cost = std::max(worst_cost, row.cost);
  }
  const Row& astar = *family.find("astar");
  const Row& dijkstra = *family.find("dijkstra");
  std::string text = fmt::format(
      "**Terrain is for those who can see it.** {} do not look at what a cell costs: on *{}* their "
      "paths cost {} to {} times the cheapest in the median.",
      listed(blind), family.title, factor(least_cost), factor(worst_cost));
  const double share = astar.expanded / dijkstra.expanded;
  text += fmt::format(" `astar` expanded {} of what `dijkstra` did there", percent(share));
  const auto elsewhere = ratios(plain, "astar", "dijkstra", &Row::expanded);
  if (2 * below(elsewhere, share).size() > elsewhere.size()) {
    text +=
        ", more than on most other maps: its estimate takes every cell for the cheapest there can "
        "be";
  }
  return text + ".";
}

std::string clearance(Families families) {
  std::vector<OnMap> spreads;
  for (const MeasuredFamily& family : families) {
    const auto [least, greatest] =
        std::minmax_element(family.planners.begin(), family.planners.end(),
                            [](const Row& a, const Row& b) { return a.clearance < b.clearance; });
    spreads.push_back({&family, greatest->clearance - least->clearance});
  }
  constexpr double kNothing = 0.05;
  const OnMap& widest = greatest_of(spreads);
  const std::string text =
      "**No planner keeps away from walls of itself.** None of them counts what is beside a path: ";
  if (widest.value < kNothing) {
    return text + "on every map the smallest clearance was the same for all, in the median.";
  }
  return text + fmt::format(
                    "on no map were the smallest clearances of two of them more than {:.1f} cells "
                    "apart, in the median (on {}).",
                    widest.value, widest.title());
}

std::string keeping_away(const ClearanceCostStudy& study) {
  const ClearanceCostRow& plain = study.rows.front();
  const ClearanceCostRow& far = study.rows.back();
  std::string text = fmt::format(
      "**Distance is a matter of the map, not of the planner.** Told to keep {} m away where there "
      "is room, the robot went with {:.2f} m of clearance on average instead of {:.2f} m, on paths "
      "{:.1f} % longer.",
      far.clearance_distance, far.clearance, plain.clearance, 100 * (far.longer - 1));
  if (far.us > plain.us) {
    text += fmt::format(
        " Planning took {} times as long with {} times the expansions: cells near walls cost more, "
        "which the estimate does not know, and costs are no whole numbers then.",
        factor(far.us / plain.us), factor(far.expanded / plain.expanded));
  }
  return text;
}

std::string walking(const MeasuredFamily& family) {
  const Row* const walk = family.find("random_walk");
  const Row& astar = *family.find("astar");
  if (walk == nullptr || family.solved_by_all == 0) return {};
  std::string text = fmt::format(
      "**Chance is no plan.** On *{}* the random walk found the goal in {} of {} cases. In the "
      "median it took {:.0f} steps where `astar` expanded {:.0f} cells, {} times the time, and "
      "its path cost {} times the cheapest.",
      family.title, walk->solved, family.queries, walk->expanded, astar.expanded,
      factor(walk->us_of_astar), factor(walk->cost));
  if (walk->solved < family.queries) {
    text += fmt::format(" The medians are over the {} queries that it did solve.",
                        family.solved_by_all);
  }
  return text;
}

std::string without_path(const MeasuredFamily& family) {
  const bool searched = std::any_of(family.planners.begin(), family.planners.end(),
                                    [](const Row& row) { return row.expanded > 0; });
  const auto [least, greatest] =
      std::minmax_element(family.planners.begin(), family.planners.end(),
                          [](const Row& a, const Row& b) { return a.us < b.us; });
  const std::string text = fmt::format("**That there is no path** took {:.2f} to {:.2f} µs to say",
                                       least->us, greatest->us);
  return text + (searched ? "; some planners searched first."
                          : ", and not a single expansion: a FreeSpace knows its connected regions "
                            "when it is made, and every planner looks there first.");
}

}  // namespace

std::string situation_findings(const Measurements& measurements) {
  const std::vector<MeasuredFamily> plain = plain_families(measurements.families);
  std::vector<std::string> paragraphs;
  for (const MeasuredFamily& family : measurements.families) {
    if (!family.eight_neighbours) paragraphs.push_back(on_four_neighbours(family));
    if (!family.uniform_terrain) paragraphs.push_back(on_terrain(family, plain));
  }
  paragraphs.push_back(clearance(plain));
  paragraphs.push_back(keeping_away(measurements.clearance_distance));
  paragraphs.push_back(walking(measurements.small));
  paragraphs.push_back(without_path(measurements.no_path));
  std::erase(paragraphs, std::string());
  return fmt::format("{}", fmt::join(paragraphs, "\n\n"));
}

}  // namespace wend::planner_page
