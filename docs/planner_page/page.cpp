#include "docs/planner_page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/measure/machine.hpp"
#include "bench/measure/markdown_table.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/planner_listing.hpp"

namespace wend::planner_page {
namespace {

constexpr std::string_view kRegistryBegins = "<!-- from the registry -->";
constexpr std::string_view kRegistryEnds = "<!-- measured -->";

constexpr std::string_view kIntroduction =
    "# Planners\n"
    "\n"
    "What each planner does, guarantees and costs, and when to choose it. `./run docs` writes this "
    "page (`--registry-only`: without measuring); do not edit it by hand.\n"
    "\n"
    "On the website, two of them search here; [the lab](lab.md) has all of them, on maps of your "
    "own.\n"
    "\n"
    "<wend-lab map=\"rooms\" size=\"61x35\" seed=\"3\" planner=\"astar dijkstra\"></wend-lab>\n"
    "<script type=\"module\" src=\"../lab/embed.js\"></script>\n";

constexpr std::string_view kAboutOverview =
    "Memory is reserved for the whole map but touched only where a search goes; a search starts in "
    "constant time.";

std::string overview_table() {
  MarkdownTable table({{"planner"}, {"terrain"}, {"preprocessing"}, {"time"}, {"memory"}});
  for (const PlannerInfo& planner : planners()) {
    table.add({fmt::format("[{0}](#{0})", planner.name), std::string(terrain_in_words(planner)),
               std::string(choice_name(planner.preprocessing)), planner.time, planner.memory});
  }
  return table.text();
}

/// Planners that share an option, with the same default and values, share a row.
std::string option_table() {
  std::vector<std::vector<std::string>> rows;
  for (const PlannerInfo& planner : planners()) {
    for (const OptionInfo& option : planner.options) {
      std::string names = fmt::format("`{}`", option.name);
      for (const std::string& alias : option.aliases) names += fmt::format(" or `{}`", alias);
      std::vector<std::string> row{names, planner.name, option.default_value, range_text(option),
                                   option.help};
      const auto same = std::ranges::find_if(rows, [&row](const std::vector<std::string>& other) {
        return other[0] == row[0] && std::equal(row.begin() + 2, row.end(), other.begin() + 2);
      });
      if (same == rows.end()) {
        rows.push_back(std::move(row));
      } else {
        (*same)[1] += ", " + planner.name;
      }
    }
  }
  MarkdownTable table({{"option"}, {"planners"}, {"default"}, {"values"}, {"meaning"}});
  for (const std::vector<std::string>& row : rows) table.add(row);
  return table.text();
}

std::string planner_section(const PlannerInfo& planner, const Picture& picture) {
  return fmt::format(
      "### {0}\n\n{1}. {2} **Guarantee**: {5}. **Use**: {6} **Paper**: {7}.\\\n"
      "![{0}'s expansions]({3}/{0}.png)\\\n*{4}*\n\n",
      planner.name, planner.summary, planner.idea, kImages, picture.caption, planner.guarantee_text,
      planner.when, planner.citation);
}

std::string registry_part(std::span<const Picture> pictures) {
  std::string sections;
  std::size_t number = 0;
  for (const PlannerInfo& planner : planners()) {
    sections += planner_section(planner, pictures[number++]);
  }
  return fmt::format("{}\n\n## Overview\n\n{}\n{} {}\n\n## Planners\n\n{}## Options\n\n{}\n",
                     kRegistryBegins, overview_table(), kAboutOverview, about_pictures(), sections,
                     option_table());
}

std::string how_it_was_measured(bool with_movingai_maps) {
  return fmt::format(
      "Times are {} of one thread on one machine ({}): compare ratios, not times. The planners "
      "take turns query by query, and each query is repeated for 5 ms; the fastest answer counts, "
      "with warm caches (`jps` caches results across queries). Numbers are medians over the "
      "queries "
      "that every planner solved; the best of a row is **bold**. Maps come from `wend generate`, "
      "seed 7{}. [performance.md](performance.md) has indexes and larger maps. "
      "`replanner` and `d_star_lite` keep the answer of a query that is repeated; "
      "[replanning.md](replanning.md) has their times.",
      thread_time_name(), describe_machine(),
      with_movingai_maps ? ", and from movingai.com (N. Sturtevant, \"Benchmarks for Grid-Based "
                           "Pathfinding\", 2012), named in brackets"
                         : "");
}

std::string measured_part(const Measurements& measurements) {
  const auto& maps = measurements.maps;
  return fmt::format(
      "{}\n\n## Measurements\n\n{}\n\n{}\n"
      "### Time\n\n`astar` in microseconds, the other planners as multiples of that.\n\n{}\n"
      "### Cells expanded\n\n{}\n"
      "### Path cost\n\nDivided by the cheapest cost: the median, and the worst in brackets. "
      "Planners without a column always found a cheapest path.\n\n{}\n"
      "### Clearance cost\n\n{}\n"
      "### Driving\n\n{}",
      kRegistryEnds, how_it_was_measured(measurements.with_movingai_maps), map_table(maps),
      time_table(maps), expanded_table(maps), cost_table(maps), measurements.clearance_cost,
      measurements.driving);
}

}  // namespace

std::string planners_page(std::span<const Picture> pictures, const Measurements& measurements) {
  return fmt::format("{}\n{}{}", kIntroduction, registry_part(pictures),
                     measured_part(measurements));
}

std::optional<std::string> with_new_registry_part(std::string_view page,
                                                  std::span<const Picture> pictures) {
  const std::size_t begin = page.find(kRegistryBegins);
  const std::size_t end = page.find(kRegistryEnds, begin == page.npos ? 0 : begin);
  if (begin == page.npos || end == page.npos) return std::nullopt;
  return fmt::format("{}{}{}", page.substr(0, begin), registry_part(pictures), page.substr(end));
}

}  // namespace wend::planner_page
