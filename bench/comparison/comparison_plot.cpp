#include "bench/comparison/comparison_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bench/comparison/comparison_measures.hpp"
#include "bench/measure/statistics.hpp"
#include "bench/plot/plot_page.hpp"
#include "bench/plot/plot_panels.hpp"

namespace wend {
namespace {

/// The values of each planner over the queries that it solved.
std::vector<PlotValues> values_of(const Comparison& comparison, std::string_view key) {
  std::vector<PlotValues> values(planners_of(comparison).size());
  for (const ComparedQuery& query : comparison.queries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (query.rows[i].found()) values[i].push_back(measure(key).of(comparison, query, i));
    }
  }
  return values;
}

/// "jps, 0.71 ms to prepare": the median over the queries.
std::string name_with_preparation(const std::string& planner, PlotValues preparation) {
  std::erase_if(preparation, [](double value) { return std::isnan(value); });
  if (preparation.empty()) return planner;
  const double median = summary_of(std::move(preparation)).median;
  if (median >= 1e6) return fmt::format("{}, {:.3g} s to prepare", planner, median / 1e6);
  if (median >= 1e3) return fmt::format("{}, {:.3g} ms to prepare", planner, median / 1e3);
  return fmt::format("{}, {:.3g} µs to prepare", planner, median);
}

class PlotScript {
 public:
  PlotScript(const Comparison& comparison, PlotKind kind, const PlotColours& colours)
      : planners_(planners_of(comparison)),
        page_(kind, colours, names_of(comparison), height_of_panels(3)),
        queries_(comparison.queries.size()),
        lengths_(values_of(comparison, comparison.frame.metric ? "length_m" : "length_cells")),
        first_(values_of(comparison, "first_query_us")),
        later_(values_of(comparison, "later_query_us")),
        expansions_(values_of(comparison, "expanded")),
        length_{.label = comparison.frame.metric ? "path length, m" : "path length, cells"},
        first_time_(time_axis(first_)),
        later_time_(time_axis(later_)),
        expansion_{.label = "expansions", .format = "%.0s%c"} {
    fit(length_, PlotScale::linear, lengths_);
    fit(first_time_, PlotScale::any, first_);
    fit(later_time_, PlotScale::any, later_);
    fit(expansion_, PlotScale::any, expansions_);
    first_time_.label.insert(0, "first query, ");
    later_time_.label.insert(0, "later queries, ");
  }

  std::string text() {
    page_.put_page();
    for (std::size_t i = 0; i < planners_.size(); ++i) put_data(i);
    page_.put("unset key\nset multiplot\n");
    put_panel(0, 2, length_, first_time_);
    page_.put_legend(
        fmt::format("Planners on {} {}", queries_, queries_ == 1 ? "query" : "queries"));
    plot_points(page_, "points", "using 1:2", lengths_);
    page_.put("unset label\n");
    put_panel(0, 1, length_, later_time_);
    plot_points(page_, "points", "using 1:3", lengths_);
    put_panel(0, 0, length_, expansion_);
    plot_points(page_, "points", "using 1:4", lengths_);
    const PlotAxis share{.label = "queries solved, %", .greatest = 100};
    put_panel(1, 2, first_time_, share);
    plot_distributions(page_, "first", lengths_);
    put_panel(1, 1, later_time_, share);
    plot_distributions(page_, "later", lengths_);
    put_panel(1, 0, expansion_, share);
    plot_distributions(page_, "expansions", lengths_);
    page_.put("unset multiplot\n");
    return page_.take();
  }

 private:
  static std::vector<std::string> names_of(const Comparison& comparison) {
    std::vector<std::string> names = planners_of(comparison);
    const std::vector<PlotValues> preparations = values_of(comparison, "preparation_us");
    for (std::size_t i = 0; i < names.size(); ++i) {
      names[i] = name_with_preparation(names[i], preparations[i]);
    }
    return names;
  }

  /// What the panels draw of one planner.
  void put_data(std::size_t planner) {
    page_.put("$points{} << END\n", planner);
    for (std::size_t i = 0; i < lengths_[planner].size(); ++i) {
      page_.put("{} {} {} {}\n", lengths_[planner][i], first_[planner][i] * first_time_.unit,
                later_[planner][i] * later_time_.unit, expansions_[planner][i]);
    }
    page_.put("END\n");
    put_distribution(page_, "first", planner, first_[planner], first_time_, queries_);
    put_distribution(page_, "later", planner, later_[planner], later_time_, queries_);
    put_distribution(page_, "expansions", planner, expansions_[planner], expansion_, queries_);
  }

  void put_panel(int column, int row, const PlotAxis& x, const PlotAxis& y) {
    page_.put_panel(panel_place(column, row), x, y);
  }

  std::vector<std::string> planners_;
  PlotPage page_;
  std::size_t queries_;
  std::vector<PlotValues> lengths_;
  std::vector<PlotValues> first_;
  std::vector<PlotValues> later_;
  std::vector<PlotValues> expansions_;
  PlotAxis length_;
  PlotAxis first_time_;
  PlotAxis later_time_;
  PlotAxis expansion_;
};

}  // namespace

std::string comparison_plot(const Comparison& comparison, PlotKind kind,
                            const PlotColours& colours) {
  return PlotScript(comparison, kind, colours).text();
}

}  // namespace wend
