#include "bench/suites/speed/speed_output.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "bench/measure/machine.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/report/build_info.hpp"
#include "wend/report/text_table.hpp"

namespace wend::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

std::string map_text(const MapTimings& map) {
  TextTable table({{"planner"},
                   {"prepare\nms", Align::right},
                   {"first\nus", Align::right},
                   {"later\nus", Align::right},
                   {"later,\nx Boost", Align::right},
                   {"expanded", Align::right},
                   {""}});
  const double boost = map.planners.front().later_us;
  for (const Timing& timing : map.planners) {
    table.add({timing.name, fmt::format("{:.2f}", timing.prepare_us * 1e-3),
               fmt::format("{:.1f}", timing.first_us), fmt::format("{:.2f}", timing.later_us),
               fmt::format("{:.2f}", boost / timing.later_us),
               fmt::format("{:.0f}", timing.expanded),
               timing.wrong == 0 ? "" : fmt::format("{} WRONG", timing.wrong)});
  }
  return fmt::format("{}: {} free cells, {} queries, {:.0f} cells a path\n{}\n", map.map,
                     map.free_cells, map.queries, map.path_cells, table.text());
}

Json json_of(const Timing& timing) {
  return {{"planner", timing.name},      {"prepare_us", timing.prepare_us},
          {"first_us", timing.first_us}, {"later_us", timing.later_us},
          {"fresh_us", timing.fresh_us}, {"alone_us", timing.alone_us},
          {"expanded", timing.expanded}, {"wrong", timing.wrong}};
}

}  // namespace

std::string speed_text(const std::vector<MapTimings>& maps) {
  std::string text = fmt::format(
      "{} of the thread. First: one run of a new planner. Later: all queries one after the\n"
      "other, the least of the runs that fill 5 ms. {}.\n\n",
      thread_time_name(), describe_machine());
  for (const MapTimings& map : maps) text += map_text(map);
  TextTable table({{"planner"},
                   {"later queries", Align::right},
                   {"first query", Align::right},
                   {"preparation", Align::right}});
  for (std::size_t i = 1; i < maps.front().planners.size(); ++i) {
    const SpeedRatios ratios = ratios_of(maps, i);
    table.add({maps.front().planners[i].name, fmt::format("{:.1f}", ratios.later),
               fmt::format("{:.1f}", ratios.first), fmt::format("{:.3g}", ratios.prepare)});
  }
  text += fmt::format("Times as fast as boost-astar, geometric mean over {} map{}:\n", maps.size(),
                      maps.size() == 1 ? "" : "s");
  return text + table.text();
}

std::string fresh_text(const std::vector<MapTimings>& maps) {
  TextTable table({{"map"},
                   {"boost-astar\nus", Align::right},
                   {"planner"},
                   {"fresh\nus", Align::right},
                   {"x Boost", Align::right},
                   {"alone\nus", Align::right},
                   {"x Boost", Align::right},
                   {""}});
  for (const MapTimings& map : maps) {
    const double boost = map.planners.front().later_us;
    for (const Timing& timing : std::span(map.planners).subspan(1)) {
      table.add(
          {map.map, fmt::format("{:.1f}", boost), timing.name,
           fmt::format("{:.1f}", timing.fresh_us), fmt::format("{:.1f}", boost / timing.fresh_us),
           fmt::format("{:.1f}", timing.alone_us), fmt::format("{:.1f}", boost / timing.alone_us),
           timing.wrong == 0 ? "" : fmt::format("{} WRONG", timing.wrong)});
    }
  }
  std::string text = fmt::format(
      "{} of the thread. Fresh: a planner made for each query, making it counted, on a free\n"
      "space that other planners have used: what they left there is not counted. Alone: the same\n"
      "on a new free space for each query, which is not counted, nor its components. Boost: later\n"
      "queries, its graph kept. {}.\n\n{}\n"
      "Times as fast as boost-astar, geometric mean over {} map{}:\n",
      thread_time_name(), describe_machine(), table.text(), maps.size(),
      maps.size() == 1 ? "" : "s");
  for (std::size_t i = 1; i < maps.front().planners.size(); ++i) {
    text += fmt::format("{}: fresh {:.1f}, alone {:.1f}\n", maps.front().planners[i].name,
                        fresh_ratio_of(maps, i, &Timing::fresh_us),
                        fresh_ratio_of(maps, i, &Timing::alone_us));
  }
  return text;
}

std::string speed_json(const std::vector<MapTimings>& maps) {
  Json json{{"schema", kSchema},           {"version", wend_version()},
            {"commit", wend_commit()},     {"machine", describe_machine()},
            {"times", thread_time_name()}, {"maps", Json::array()},
            {"ratios", Json::array()}};
  for (const MapTimings& map : maps) {
    Json row{{"map", map.map},
             {"free_cells", map.free_cells},
             {"queries", map.queries},
             {"path_cells", map.path_cells},
             {"planners", Json::array()}};
    for (const Timing& timing : map.planners) row["planners"].push_back(json_of(timing));
    json["maps"].push_back(std::move(row));
  }
  for (std::size_t i = 1; i < maps.front().planners.size(); ++i) {
    const SpeedRatios ratios = ratios_of(maps, i);
    json["ratios"].push_back({{"planner", maps.front().planners[i].name},
                              {"later", ratios.later},
                              {"first", ratios.first},
                              {"prepare", ratios.prepare}});
  }
  return json.dump(2) + "\n";
}

}  // namespace wend::bench
