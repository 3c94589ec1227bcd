#include "bench/scaling/scaling_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "bench/measure/machine.hpp"

namespace wend::bench {
namespace {

constexpr const char* kIntroduction = R"(# How planners grow with the map

Written by `./run scaling`, which measures for some minutes; `./run scaling --help` says how to measure less.

Maps come from `wend generate`, seed 7; start and goal are random cells that a path joins, the same for every planner. Every
planner is measured in a process of its own: its memory is what it has beside the map, with its index. Times are CPU
time of the thread and means over the queries of a map. A first query is that of a new planner, of up to ten; later queries
are the same ones again, one after the other. A slow planner answers fewer queries: none begins after {} s.
Paths are compared: {}.

{}

)";

constexpr const char* kLeftOut =
    "An index is left out (–) where it would take more than {:.0f} s to build, going by the map "
    "before; a planner\n"
    "where a query took more than {:.0f} s on the map before; Boost.Graph's A* above {} x {} "
    "cells.\n\n";

/// Three significant digits.
std::string digits(double value) {
  constexpr double kLarge = 100;
  return value >= kLarge ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

using Field = std::function<std::string(const PlannerScale&)>;

class Page {
 public:
  Page(const ScalingPlan& plan, const std::vector<MapScale>& maps) : plan_(plan), maps_(maps) {}

  std::string text(const std::string& picture) {
    text_ = fmt::format(fmt::runtime(kIntroduction), plan_.query_seconds,
                        any_wrong() ? "some were WRONG" : "every planner found the same lengths",
                        describe_machine());
    text_ += fmt::format("![Time, memory and build time against cells]({})\n\n", picture);
    text_ += fmt::format(fmt::runtime(kLeftOut), plan_.most_build_seconds, plan_.most_query_seconds,
                         plan_.largest_for_boost, plan_.largest_for_boost);
    put_tables("To make a planner, in milliseconds", all(),
               [](const PlannerScale& scale) { return digits(scale.prepare_ms); });
    put_tables("Its first query, in microseconds", all(),
               [](const PlannerScale& scale) { return digits(scale.first_us); });
    put_tables("A later query, in microseconds", all(),
               [](const PlannerScale& scale) { return digits(scale.later_us); });
    put_tables("Two threads", all(), [](const PlannerScale& scale) {
      return fmt::format("{:.2f}", scale.two_threads_gain);
    });
    put_tables("Memory, in MB", all(), [](const PlannerScale& scale) {
      return digits(static_cast<double>(scale.memory_bytes) * 1e-6);
    });
    put_tables("Building an index: seconds on one core, and its MB", with_index(),
               [](const PlannerScale& scale) {
                 return fmt::format("{}; {}", digits(scale.build_s),
                                    digits(static_cast<double>(scale.index_bytes) * 1e-6));
               });
    put_maps();
    return std::move(text_);
  }

 private:
  bool any_wrong() const {
    return std::any_of(maps_.begin(), maps_.end(), [](const MapScale& map) {
      return std::any_of(map.planners.begin(), map.planners.end(),
                         [](const auto& scale) { return scale && scale->wrong; });
    });
  }

  std::vector<std::size_t> all() const {
    std::vector<std::size_t> places(plan_.planners.size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    return places;
  }

  std::vector<std::size_t> with_index() const {
    std::vector<std::size_t> places;
    for (const std::size_t i : all()) {
      const bool built = std::any_of(maps_.begin(), maps_.end(), [i](const MapScale& map) {
        return map.planners[i] && map.planners[i]->index_bytes > 0;
      });
      if (built) places.push_back(i);
    }
    return places;
  }

  /// A table for each kind of map: a row a size, a column a planner.
  void put_tables(const std::string& title, const std::vector<std::size_t>& planners,
                  const Field& field) {
    if (planners.empty()) return;
    text_ += fmt::format("## {}\n\n", title);
    if (title == "Two threads") {
      text_ +=
          "How many times as many queries two threads answer in the same time as one does, on one "
          "map and index, each thread with a planner of its own.\n\n";
    }
    for (const MapKind& kind : plan_.kinds) {
      text_ += fmt::format("| {} |", kind.name);
      for (const std::size_t i : planners) text_ += fmt::format(" `{}` |", plan_.planners[i]);
      text_ += "\n|---|";
      for (std::size_t i = 0; i < planners.size(); ++i) text_ += "---:|";
      text_ += "\n";
      for (const MapScale& map : maps_) {
        if (map.kind.name != kind.name) continue;
        text_ += fmt::format("| {0} x {0} |", map.size);
        for (const std::size_t i : planners) {
          const std::optional<PlannerScale>& scale = map.planners[i];
          text_ += fmt::format(" {} |", scale ? field(*scale) : "–");
        }
        text_ += "\n";
      }
      text_ += "\n";
    }
  }

  void put_maps() {
    text_ +=
        "## The maps\n\n| map | free cells | seconds to make its `FreeSpace` |\n|---|---:|---:|\n";
    for (const MapScale& map : maps_) {
      text_ += fmt::format("| {0}, {1} x {1} | {2} | {3} |\n", map.kind.name, map.size,
                           map.free_cells, digits(map.space_s));
    }
  }

  const ScalingPlan& plan_;
  const std::vector<MapScale>& maps_;
  std::string text_;
};

}  // namespace

std::string scaling_page(const ScalingPlan& plan, const std::vector<MapScale>& maps,
                         const std::string& picture) {
  return Page(plan, maps).text(picture);
}

}  // namespace wend::bench
