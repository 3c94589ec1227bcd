#include "bench/scenario/bench_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "bench/plot/plot_page.hpp"
#include "bench/plot/plot_panels.hpp"

namespace wend {
namespace {

constexpr double kMicroseconds = 1e6;      // in a second
constexpr std::size_t kMostPoints = 2000;  // of a planner
using TimesBySize = std::map<std::uint64_t, PlotValues>;

/// The planners' answers on all maps; entry i of each vector belongs to planner i.
struct Series {
  std::vector<std::string> planners{};
  std::vector<PlotValues> lengths{};  // over the queries that it solved
  std::vector<PlotValues> times{};    // of these, in microseconds
  std::vector<TimesBySize> by_size{};
  std::vector<std::size_t> queries{};

  std::size_t place_of(const std::string& planner) {
    const auto found = std::find(planners.begin(), planners.end(), planner);
    if (found != planners.end()) return static_cast<std::size_t>(found - planners.begin());
    planners.push_back(planner);
    lengths.emplace_back();
    times.emplace_back();
    by_size.emplace_back();
    queries.push_back(0);
    return planners.size() - 1;
  }

  bool has_sizes() const {
    return std::any_of(by_size.begin(), by_size.end(),
                       [](const TimesBySize& sizes) { return sizes.size() > 1; });
  }
};

Series series_of(std::span<const BenchedMap> maps) {
  Series series;
  for (const BenchedMap& map : maps) {
    const std::size_t planner = series.place_of(map.planner);
    series.queries[planner] += map.answers.size();
    for (const BenchAnswer& answer : map.answers) {
      if (!answer.found()) continue;
      const double time = kMicroseconds * answer.fastest();
      series.lengths[planner].push_back(answer.length);
      series.times[planner].push_back(time);
      series.by_size[planner][map.free_cells].push_back(time);
    }
  }
  return series;
}

double mean_of(const PlotValues& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

class BenchScript {
 public:
  BenchScript(Series series, PlotKind kind, const PlotColours& colours)
      : series_(std::move(series)),
        rows_(series_.has_sizes() ? 2 : 1),
        page_(kind, colours, series_.planners, height_of_panels(rows_)),
        time_(time_axis(series_.times)) {
    fit(length_, PlotScale::linear, series_.lengths);
    fit(time_, PlotScale::any, series_.times);
  }

  std::string text() {
    page_.put_page();
    for (std::size_t i = 0; i < series_.planners.size(); ++i) put_data(i);
    page_.put("unset key\nset multiplot\n");
    page_.put_panel(panel_place(0, rows_ - 1), length_, time_);
    page_.put_legend(headline());
    plot_points(page_, "points", "using 1:2", series_.lengths);
    page_.put("unset label\n");
    page_.put_panel(panel_place(1, rows_ - 1), time_,
                    {.label = "queries solved, %", .greatest = 100});
    plot_distributions(page_, "time", series_.times);
    if (rows_ > 1) put_scaling();
    page_.put("unset multiplot\n");
    return page_.take();
  }

 private:
  std::string headline() const {
    const std::size_t most =
        series_.queries.empty() ? 0
                                : *std::max_element(series_.queries.begin(), series_.queries.end());
    return fmt::format("Planners on {} {}", most, most == 1 ? "query" : "queries");
  }

  void put_data(std::size_t planner) {
    const std::size_t count = series_.lengths[planner].size();
    const std::size_t points = std::min(count, kMostPoints);
    page_.put("$points{} << END\n", planner);
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t at = i * count / points;
      page_.put("{} {}\n", series_.lengths[planner][at], series_.times[planner][at] * time_.unit);
    }
    page_.put("END\n");
    put_distribution(page_, "time", planner, series_.times[planner], time_,
                     series_.queries[planner]);
    page_.put("$sizes{} << END\n", planner);
    for (const auto& [cells, times] : series_.by_size[planner]) {
      page_.put("{} {}\n", cells, mean_of(times) * time_.unit);
    }
    page_.put("END\n");
  }

  void put_scaling() {
    PlotAxis cells{.label = "free cells of the map", .format = "%.0s%c"};
    PlotAxis mean = time_;
    std::vector<PlotValues> sizes(1);
    std::vector<PlotValues> means(1);
    for (const TimesBySize& of_planner : series_.by_size) {
      for (const auto& [size, times] : of_planner) {
        sizes.front().push_back(static_cast<double>(size));
        means.front().push_back(mean_of(times));
      }
    }
    fit(cells, PlotScale::any, sizes);
    fit(mean, PlotScale::any, means);
    mean.label = "mean " + mean.label;
    page_.put_panel(panel_place(0, 0), cells, mean);
    page_.put("plot NaN notitle");
    for (std::size_t i = 0; i < series_.planners.size(); ++i) {
      if (series_.by_size[i].empty()) continue;
      page_.put(", \\\n  $sizes{} using 1:2 with linespoints {} notitle", i, page_.point_look(i));
    }
    page_.put("\n");
  }

  Series series_;
  int rows_;
  PlotPage page_;
  PlotAxis length_{.label = "path length, cells"};
  PlotAxis time_;
};

}  // namespace

std::string bench_plot(std::span<const BenchedMap> maps, PlotKind kind,
                       const PlotColours& colours) {
  return BenchScript(series_of(maps), kind, colours).text();
}

}  // namespace wend
