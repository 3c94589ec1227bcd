#include "wend/report/comparison_plot.hpp"

#include <fmt/format.h>

#include "wend/report/comparison_measures.hpp"
#include "wend/report/plot_page.hpp"
#include "wend/report/plot_panels.hpp"

namespace wend {
namespace {

/// Of each planner, over the queries that it solved.
std::vector<PlotValues> values_of(const Comparison& comparison, std::string_view key) {
  std::vector<PlotValues> values(planners_of(comparison).size());
  for (const ComparedQuery& query : comparison.queries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (query.rows[i].found()) values[i].push_back(measure(key).of(comparison, query, i));
    }
  }
  return values;
}

class PlotScript {
 public:
  PlotScript(const Comparison& comparison, PlotKind kind, const PlotColours& colours)
      : planners_(planners_of(comparison)),
        page_(kind, colours, planners_, height_of_panels(2)),
        queries_(comparison.queries.size()),
        lengths_(values_of(comparison, comparison.frame.metric ? "length_m" : "length_cells")),
        times_(values_of(comparison, "time_us")),
        expansions_(values_of(comparison, "expanded")),
        length_{.label = comparison.frame.metric ? "path length, m" : "path length, cells"},
        time_(time_axis(times_)),
        expansion_{.label = "expansions", .format = "%.0s%c"} {
    fit(length_, PlotScale::linear, lengths_);
    fit(time_, PlotScale::any, times_);
    fit(expansion_, PlotScale::any, expansions_);
  }

  std::string text() {
    page_.put_page();
    for (std::size_t i = 0; i < planners_.size(); ++i) put_data(i);
    page_.put("unset key\nset multiplot\n");
    put_panel(0, 1, length_, time_);
    page_.put_legend(
        fmt::format("Planners on {} {}", queries_, queries_ == 1 ? "query" : "queries"));
    plot_points(page_, "points", "using 1:2", lengths_);
    page_.put("unset label\n");
    put_panel(1, 1, length_, expansion_);
    plot_points(page_, "points", "using 1:3", lengths_);
    const PlotAxis share{.label = "queries solved, %", .greatest = 100};
    put_panel(0, 0, time_, share);
    plot_distributions(page_, "time", lengths_);
    put_panel(1, 0, expansion_, share);
    plot_distributions(page_, "expansions", lengths_);
    page_.put("unset multiplot\n");
    return page_.take();
  }

 private:
  /// What the panels draw of one planner.
  void put_data(std::size_t planner) {
    page_.put("$points{} << END\n", planner);
    for (std::size_t i = 0; i < lengths_[planner].size(); ++i) {
      page_.put("{} {} {}\n", lengths_[planner][i], times_[planner][i] * time_.unit,
                expansions_[planner][i]);
    }
    page_.put("END\n");
    put_distribution(page_, "time", planner, times_[planner], time_, queries_);
    put_distribution(page_, "expansions", planner, expansions_[planner], expansion_, queries_);
  }

  void put_panel(int column, int row, const PlotAxis& x, const PlotAxis& y) {
    page_.put_panel(panel_place(column, row), x, y);
  }

  std::vector<std::string> planners_;
  PlotPage page_;
  std::size_t queries_;
  std::vector<PlotValues> lengths_;
  std::vector<PlotValues> times_;
  std::vector<PlotValues> expansions_;
  PlotAxis length_;
  PlotAxis time_;
  PlotAxis expansion_;
};

}  // namespace

std::string comparison_plot(const Comparison& comparison, PlotKind kind,
                            const PlotColours& colours) {
  return PlotScript(comparison, kind, colours).text();
}

}  // namespace wend
