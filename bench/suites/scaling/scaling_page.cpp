#include "bench/suites/scaling/scaling_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "bench/measure/machine.hpp"
#include "bench/measure/markdown_table.hpp"
#include "wend/report/text_table.hpp"

namespace wend::bench {
namespace {

/// Five sentences.
std::string introduction(const ScalingPlan& plan, bool any_wrong) {
  return fmt::format(
      "# Planning time and memory by map size\n\n"
      "`./run scaling` writes this page: it asks every planner the same random queries on growing "
      "maps of `wend generate`, seed 7, each planner in a process of its own ({}). "
      "Times are mean CPU times over the queries of a map (no new query after {} s): a first query "
      "is the first of a new planner, a later query repeats one with warm caches. "
      "Memory is what a planner needs beside the map, its index included. "
      "A dash stands for an index that would take more than {:.0f} s to build, for a planner that "
      "took more than {:.0f} s a query on the map before, and for Boost.Graph's A* above {} x {} "
      "cells. {}\n\n",
      describe_machine(), plan.query_seconds, plan.most_build_seconds, plan.most_query_seconds,
      plan.largest_for_boost, plan.largest_for_boost,
      any_wrong ? "Some planners found paths of a WRONG cost."
                : "All planners found paths of the same cost.");
}

/// Three significant digits.
std::string digits(double value) {
  constexpr double kLarge = 100;
  return value >= kLarge ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

using Field = std::function<std::string(const PlannerScale&)>;

/// The planners' places in the plan; of those with an index, where any map has one.
std::vector<std::size_t> planner_places(const std::vector<MapScale>& maps, bool indexed) {
  std::vector<std::size_t> places;
  const std::size_t count = maps.empty() ? 0 : maps.front().planners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool built = std::any_of(maps.begin(), maps.end(), [i](const MapScale& map) {
      return map.planners[i] && map.planners[i]->index_bytes > 0;
    });
    if (built || !indexed) places.push_back(i);
  }
  return places;
}

std::string map_name(const MapScale& map) {
  return fmt::format("{0}, {1} x {1}", map.kind.name, map.size);
}

/// One row per map, one column per planner.
std::string section(const ScalingPlan& plan, const std::vector<MapScale>& maps,
                    std::string_view title, const Field& field, bool indexed = false) {
  const std::vector<std::size_t> places = planner_places(maps, indexed);
  if (places.empty()) return {};
  std::vector<TextTable::Column> columns{{"map"}};
  for (const std::size_t i : places) {
    columns.push_back({fmt::format("`{}`", plan.planners[i]), Align::right});
  }
  MarkdownTable table(std::move(columns));
  for (const MapScale& map : maps) {
    std::vector<std::string> row{map_name(map)};
    for (const std::size_t i : places) {
      const auto& planner = map.planners[i];
      row.push_back(planner ? field(*planner) : "–");
    }
    table.add(row);
  }
  return fmt::format("## {}\n\n{}\n", title, table.text());
}

std::string map_section(const std::vector<MapScale>& maps) {
  MarkdownTable table(
      {{"map"}, {"free cells", Align::right}, {"seconds to make its `FreeSpace`", Align::right}});
  for (const MapScale& map : maps) {
    table.add({map_name(map), std::to_string(map.free_cells), digits(map.space_s)});
  }
  return "## Maps\n\n" + table.text();
}

std::string in_megabytes(std::uint64_t bytes) { return digits(static_cast<double>(bytes) * 1e-6); }

}  // namespace

std::string scaling_page(const ScalingPlan& plan, const std::vector<MapScale>& maps,
                         const std::string& picture) {
  const bool any_wrong = std::any_of(maps.begin(), maps.end(), [](const MapScale& map) {
    return std::any_of(map.planners.begin(), map.planners.end(),
                       [](const auto& scale) { return scale && scale->wrong; });
  });
  std::string text = introduction(plan, any_wrong);
  text += fmt::format("![Time, memory and index build time by map size]({})\n\n", picture);
  const auto put = [&](std::string_view title, const Field& field, bool indexed = false) {
    text += section(plan, maps, title, field, indexed);
  };
  put("First query, microseconds", [](const auto& scale) { return digits(scale.first_us); });
  put("Later query, microseconds", [](const auto& scale) { return digits(scale.later_us); });
  put("Two threads: queries answered, over those of one thread",
      [](const auto& scale) { return fmt::format("{:.2f}", scale.two_threads_gain); });
  put("Memory, MB", [](const auto& scale) { return in_megabytes(scale.memory_bytes); });
  put("Making a planner, milliseconds", [](const auto& scale) { return digits(scale.prepare_ms); });
  put(
      "Building an index: seconds on one core, and its MB",
      [](const auto& scale) {
        return fmt::format("{}; {}", digits(scale.build_s), in_megabytes(scale.index_bytes));
      },
      true);
  return text + map_section(maps);
}

}  // namespace wend::bench
