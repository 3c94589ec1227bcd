#include "docs/planner_page/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "docs/planner_page/markdown.hpp"
#include "docs/planner_page/ratios.hpp"
#include "docs/planner_page/situation_findings.hpp"

namespace wend::planner_page {
namespace {

using Families = std::span<const MeasuredFamily>;
using Row = MeasuredPlanner;

constexpr std::string_view kWeighted = "astar:weight=2";
constexpr std::string_view kEuclidean = "astar:heuristic=euclidean";
constexpr double kRounding = 1 + 1e-9;

std::string estimate(Families families) {
  const auto share = ratios(families, "astar", "dijkstra", &Row::expanded);
  const OnMap& low = least_of(share);
  const OnMap& high = greatest_of(share);
  std::string text = fmt::format(
      "**An estimate helps as far as it is right.** `astar` expanded {} of the cells that "
      "`dijkstra` did on {} and {} on {}: the estimate is the distance as if nothing were in the "
      "way.",
      percent(low.value), low.title(), percent(high.value), high.title());
  if (high.family->is_maze && !low.family->is_maze) {
    text +=
        " In a maze the way leads away from the goal as often as towards it, and every dead end "
        "that points at the goal is searched to its end.";
  }
  const auto faster = below(ratios(families, "dijkstra", "astar", &Row::us), 1);
  if (faster.empty()) return text + " `dijkstra` was never the faster of the two.";
  text += fmt::format(" `dijkstra` was the faster of the two on {}", titles(faster));
  const bool dearer = std::all_of(faster.begin(), faster.end(), [](const OnMap& on) {
    return on.family->find("astar")->ns_an_expansion > on.family->find("dijkstra")->ns_an_expansion;
  });
  return text +
         (dearer ? ": there the estimate saves less than it costs to compute and sort by." : ".");
}

std::string greedy(Families families) {
  const auto time = ratios(families, "greedy", "astar", &Row::us);
  const auto faster = below(time, 1);
  std::string text = fmt::format(
      "**Greed is quick, and pays with the path.** `greedy` was faster than `astar` on {} of {} "
      "maps",
      faster.size(), time.size());
  const OnMap& best = least_of(time);
  if (!faster.empty()) {
    const Row& row = *best.family->find("greedy");
    text += fmt::format(", most on {}: {} times as fast with {} of the expansions", best.title(),
                        factor(1 / best.value),
                        percent(row.expanded / best.family->find("astar")->expanded));
  }
  const auto cost = values_of(families, "greedy", &Row::cost);
  const OnMap worst = greatest_of(values_of(families, "greedy", &Row::worst_cost));
  text += fmt::format(
      ". Its paths cost {} times the cheapest in the median, and {} times at the worst (on "
      "{}): what a detour has cost already does not enter its order.",
      range_of(cost, factor), factor(worst.value), worst.title());
  const OnMap& slowest = greatest_of(time);
  if (slowest.value > 1) {
    text += fmt::format(" On {} it was slower than `astar`, {} times as slow at most.",
                        titles(below(ratios(families, "astar", "greedy", &Row::us), 1)),
                        factor(slowest.value));
  }
  return text;
}

/// Of the cells that plain astar expands, on each map.
std::vector<OnMap> weighted_shares(const std::vector<OnMap>& maps) {
  std::vector<OnMap> shares;
  for (const OnMap& on : maps) {
    const double plain = on.family->find("astar")->expanded;
    shares.push_back({on.family, on.family->find(kWeighted)->expanded / plain});
  }
  return shares;
}

/// Where a weight made A* faster, and where slower.
std::string gain_of_weight(Families families) {
  const auto time = ratios(families, kWeighted, "astar", &Row::us);
  const auto faster = below(time, 1);
  const auto slower = below(ratios(families, "astar", kWeighted, &Row::us), 1);
  std::string text;
  if (!faster.empty()) {
    text += fmt::format(" and was faster on {}, up to {} times", titles(faster),
                        factor(1 / least_of(time).value));
  }
  if (!slower.empty()) {
    text += fmt::format("{} slower on {}, up to {} times", faster.empty() ? " and was" : ", but",
                        titles(slower), factor(greatest_of(time).value));
  }
  text += ".";
  if (faster.empty() || slower.empty()) return text;
  const double most = greatest_of(weighted_shares(faster)).value;
  if (most >= least_of(weighted_shares(slower)).value) return text;
  return text +
         fmt::format(" It paid off where it expanded no more than {} of the cells.", percent(most));
}

std::string weight(Families families) {
  const OnMap worst = greatest_of(values_of(families, kWeighted, &Row::worst_cost));
  constexpr double kPromised = 2;
  std::string text = "**A weight is a bound, not always a gain.** ";
  if (worst.value <= kPromised * kRounding) {
    text += fmt::format(
        "With weight 2 a path may cost twice the optimum; the dearest cost {} times (on {}). ",
        factor(worst.value), worst.title());
  }
  const auto expanded = ratios(families, kWeighted, "astar", &Row::expanded);
  const auto each = ratios(families, kWeighted, "astar", &Row::ns_an_expansion);
  text += fmt::format("It expanded {} of the cells of plain `astar`{} ",
                      range_of(expanded, percent), gain_of_weight(families));
  text += fmt::format("Each of its expansions took {} times as long.", range_of(each, factor));
  if (least_of(each).value > 1) {
    text +=
        " Plain `astar` has whole-number keys, which go into buckets, and passes over moves that "
        "only lead to a cell by another order of the same steps. A weighted search can do neither: "
        "its keys are real numbers in a heap, and it may want those moves.";
  }
  return text;
}

std::string euclidean(Families families) {
  const auto expanded = ratios(families, kEuclidean, "astar", &Row::expanded);
  const auto time = ratios(families, kEuclidean, "astar", &Row::us);
  const auto worst = values_of(families, kEuclidean, &Row::worst_cost);
  std::string text = "**The estimate should fit the moves.** With `heuristic=euclidean` `astar` ";
  if (greatest_of(worst).value <= kRounding) text += "finds paths of the same cost, but ";
  text += fmt::format("expanded {} times as many cells and took {} times as long.",
                      range_of(expanded, factor), range_of(time, factor));
  if (least_of(expanded).value >= 1) {
    text +=
        " A straight line is mostly shorter than what a robot can do on 8 neighbours, so it "
        "says less than `octile`, which counts diagonal and straight steps; and its keys are "
        "no whole numbers.";
  }
  return text;
}

std::string fewest_steps(Families families) {
  const auto time = ratios(families, "bfs", "dijkstra", &Row::us);
  const auto faster = below(time, 1);
  const auto cost = values_of(families, "bfs", &Row::cost);
  std::string text = fmt::format(
      "**Fewest steps are not the shortest way.** On 8 neighbours `bfs` takes a diagonal step for "
      "no longer than a straight one: its paths cost {} times the cheapest in the median. ",
      range_of(cost, factor));
  text += fmt::format("It was faster than `dijkstra` on {} of {} maps", faster.size(), time.size());
  if (!faster.empty()) text += fmt::format(" ({})", titles(faster));
  text += fmt::format(", and took {} times its time. ", range_of(time, factor));
  const auto each = ratios(families, "bfs", "dijkstra", &Row::ns_an_expansion);
  text += fmt::format("One of its expansions took {} times as long as one of `dijkstra`: ",
                      range_of(each, factor));
  text += greatest_of(each).value < 1
              ? "a queue needs no keys and no order."
              : "a queue needs no keys and no order, but the nodes of `dijkstra` are half as large "
                "here, and it passes over moves that only repeat others.";
  return text;
}

std::string depth(Families families) {
  const auto cost = values_of(families, "dfs", &Row::cost);
  const OnMap& worst = greatest_of(cost);
  std::string text = fmt::format(
      "**A stack wanders.** The paths of `dfs` cost up to {} times the cheapest in the median (on "
      "{}), because the last cell that it reached is rarely nearer to the goal.",
      factor(worst.value), worst.title());
  std::vector<OnMap> same;
  for (const OnMap& on : values_of(families, "dfs", &Row::worst_cost)) {
    if (on.family->is_maze && on.value <= kRounding) same.push_back(on);
  }
  if (!same.empty()) {
    text += fmt::format(
        " On {} they were the cheapest all the same: where one way joins any two places, there "
        "is no other to find.",
        titles(same));
  }
  return text;
}

std::string in_short(Families families) {
  const auto most_often = [&](const auto& qualifies) {
    std::vector<std::string> winners;
    for (const MeasuredFamily& family : families) {
      const Row* best = nullptr;
      for (const Row& row : family.planners) {
        if (qualifies(row) && (best == nullptr || row.us < best->us)) best = &row;
      }
      if (best != nullptr) winners.push_back(best->role);
    }
    const auto wins = [&](const std::string& role) {
      return std::count(winners.begin(), winners.end(), role);
    };
    const auto most = std::max_element(
        winners.begin(), winners.end(),
        [&](const std::string& a, const std::string& b) { return wins(a) < wins(b); });
    return fmt::format("`{}` was the fastest on {} of {} maps", *most, wins(*most),
                       families.size());
  };
  return fmt::format(
      "**In short.** Of the planners that found nothing but cheapest paths on a map, {}. Of all, "
      "{}.",
      most_often([](const Row& row) { return row.always_cheapest(); }),
      most_often([](const Row&) { return true; }));
}

}  // namespace

std::string findings(const Measurements& measurements) {
  const std::vector<MeasuredFamily> plain = plain_families(measurements.families);
  std::string text = in_short(measurements.families);
  for (const auto& paragraph :
       {estimate(plain), greedy(plain), weight(plain), euclidean(plain), fewest_steps(plain),
        depth(plain), situation_findings(measurements)}) {
    text += "\n\n" + paragraph;
  }
  if (!measurements.drives.yards.empty()) text += "\n\n" + drive_findings(measurements.drives);
  return text + '\n';
}

}  // namespace wend::planner_page
