// The picture of docs/performance.md.

#include <fmt/format.h>

#include <algorithm>

#include "bench/plot/plot_page.hpp"
#include "bench/plot/plot_panels.hpp"
#include "bench/suites/scaling/scaling_page.hpp"

namespace wend::bench {
namespace {

/// A value of a planner on a map, or none.
using Measure = std::optional<double> (*)(const PlannerScale&);

std::optional<double> query_us(const PlannerScale& scale) { return scale.later_us; }
std::optional<double> megabytes(const PlannerScale& scale) {
  return static_cast<double>(scale.memory_bytes) * 1e-6;
}
std::optional<double> build_seconds(const PlannerScale& scale) {
  return scale.index_bytes > 0 ? std::optional(scale.build_s) : std::nullopt;
}

class ScalingScript {
 public:
  ScalingScript(const ScalingPlan& plan, const std::vector<MapScale>& maps, PlotKind kind)
      : plan_(plan),
        maps_(maps),
        rows_(static_cast<int>(plan.kinds.size()) + 1),
        page_(kind, kLightPlot, plan.planners, height_of_panels(rows_)) {}

  /// A row of panels a kind of map, time and memory; below it, the build times of the first two.
  std::string text() {
    page_.put_page();
    page_.put("unset key\nset multiplot\n");
    bool first = true;
    for (std::size_t kind = 0; kind < plan_.kinds.size(); ++kind) {
      const int row = rows_ - 1 - static_cast<int>(kind);
      const std::string name = plan_.kinds[kind].name;
      put_panel(0, row, kind, "later query, µs: " + name, query_us, first);
      put_panel(1, row, kind, "memory, MB: " + name, megabytes, false);
      if (kind < 2) {
        put_panel(static_cast<int>(kind), 0, kind, "index build, s: " + name, build_seconds, false);
      }
      first = false;
    }
    page_.put("unset multiplot\n");
    return page_.take();
  }

 private:
  void put_panel(int column, int row, std::size_t kind, const std::string& label, Measure measure,
                 bool legend) {
    std::vector<PlotValues> cells(plan_.planners.size());
    std::vector<PlotValues> values(plan_.planners.size());
    for (const MapScale& map : maps_) {
      if (map.kind.name != plan_.kinds[kind].name) continue;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<PlannerScale>& scale = map.planners[i];
        const auto value = scale ? measure(*scale) : std::nullopt;
        if (!value) continue;
        cells[i].push_back(map.cells());
        values[i].push_back(*value);
      }
    }
    PlotAxis x{.label = "cells of the map", .format = "%.0s%c"};
    PlotAxis y{.label = label};
    fit(x, PlotScale::any, cells);
    fit(y, PlotScale::any, values);
    put_data(column, row, cells, values);
    page_.put_panel(panel_place(column, row), x, y);
    if (legend) page_.put_legend("Time, memory and index build times against the size of the map");
    page_.put("plot NaN notitle");
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].empty()) continue;
      page_.put(", \\\n  $d{}_{}_{} using 1:2 with linespoints {} notitle", column, row, i,
                page_.point_look(i));
    }
    page_.put("\n");
    if (legend) page_.put("unset label\n");
  }

  void put_data(int column, int row, const std::vector<PlotValues>& cells,
                const std::vector<PlotValues>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      page_.put("$d{}_{}_{} << END\n", column, row, i);
      for (std::size_t k = 0; k < values[i].size(); ++k) {
        page_.put("{} {}\n", cells[i][k], values[i][k]);
      }
      page_.put("END\n");
    }
  }

  const ScalingPlan& plan_;
  const std::vector<MapScale>& maps_;
  int rows_;
  PlotPage page_;
};

}  // namespace

std::string scaling_plot(const ScalingPlan& plan, const std::vector<MapScale>& maps,
                         PlotKind kind) {
  return ScalingScript(plan, maps, kind).text();
}

}  // namespace wend::bench
