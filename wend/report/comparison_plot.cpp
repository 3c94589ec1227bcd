#include "wend/report/comparison_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "wend/report/comparison_measures.hpp"
#include "wend/report/plot_page.hpp"

namespace wend {
namespace {

constexpr double kLogarithmicFrom = 100;                      // greatest / least
constexpr std::array kMarkedShares{0.1, 0.3, 0.5, 0.7, 0.9};  // of a cumulative distribution

// In pixels.
constexpr double kPanelWidth = 540;
constexpr double kPanelHeight = 380;
constexpr double kLeft = 125;
constexpr double kColumn = 700;  // from one panel to the next
constexpr double kRow = 495;
constexpr double kBottom = 95;

/// One planner's value of a measure for each query that it solved.
using Values = std::vector<double>;

enum class Scale { linear, any };

/// From 0, or from decade to decade.
void fit(PlotAxis& axis, Scale scale, const std::vector<Values>& planners) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const Values& values : planners) {
    for (const double value : values) {
      least = std::min(least, value * axis.unit);
      greatest = std::max(greatest, value * axis.unit);
    }
  }
  if (greatest <= 0) return;
  axis.greatest = greatest * 1.05;
  if (scale == Scale::linear || least <= 0 || greatest / least < kLogarithmicFrom) return;
  axis.logarithmic = true;
  axis.least = std::pow(10, std::floor(std::log10(least)));
  axis.greatest = std::pow(10, std::ceil(std::log10(greatest)));
}

/// Of each planner, over the queries that it solved.
std::vector<Values> values_of(const Comparison& comparison, std::string_view key) {
  std::vector<Values> values(planners_of(comparison).size());
  for (const ComparedQuery& query : comparison.queries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (query.rows[i].found()) values[i].push_back(measure(key).of(comparison, query, i));
    }
  }
  return values;
}

/// Microseconds, milliseconds or seconds, so that the numbers are neither small nor large.
PlotAxis time_axis(const std::vector<Values>& microseconds) {
  Values all;
  for (const Values& values : microseconds) all.insert(all.end(), values.begin(), values.end());
  const double median = summary_of(std::move(all)).median;
  if (median >= 1e6) return {.label = "time, s", .unit = 1e-6};
  if (median >= 1e3) return {.label = "time, ms", .unit = 1e-3};
  return {.label = "time, µs"};
}

class PlotScript {
 public:
  PlotScript(const Comparison& comparison, PlotKind kind, const PlotColours& colours)
      : planners_(planners_of(comparison)),
        page_(kind, colours, planners_, kBottom + kRow + kPanelHeight),
        queries_(comparison.queries.size()),
        lengths_(values_of(comparison, comparison.frame.metric ? "length_m" : "length_cells")),
        times_(values_of(comparison, "time_us")),
        expansions_(values_of(comparison, "expanded")),
        length_{.label = comparison.frame.metric ? "path length, m" : "path length, cells"},
        time_(time_axis(times_)),
        expansion_{.label = "expansions", .format = "%.0s%c"} {
    fit(length_, Scale::linear, lengths_);
    fit(time_, Scale::any, times_);
    fit(expansion_, Scale::any, expansions_);
  }

  std::string text() {
    page_.put_page();
    for (std::size_t i = 0; i < planners_.size(); ++i) put_data(i);
    page_.put("unset key\nset multiplot\n");
    put_panel(0, 1, length_, time_);
    page_.put_legend(
        fmt::format("Planners on {} {}", queries_, queries_ == 1 ? "query" : "queries"));
    put_plot("points", "using 1:2");
    page_.put("unset label\n");
    put_panel(1, 1, length_, expansion_);
    put_plot("points", "using 1:3");
    const PlotAxis share{.label = "queries solved, %", .greatest = 100};
    put_panel(0, 0, time_, share);
    put_distributions("time");
    put_panel(1, 0, expansion_, share);
    put_distributions("expansions");
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
    put_distribution("time", planner, times_[planner], time_);
    put_distribution("expansions", planner, expansions_[planner], expansion_);
  }

  /// Steps from edge to edge of the panel, and some marks on them.
  void put_distribution(std::string_view name, std::size_t planner, Values values,
                        const PlotAxis& axis) {
    std::sort(values.begin(), values.end());
    const auto percent = [this](std::size_t count) {
      return 100 * static_cast<double>(count) / static_cast<double>(queries_);
    };
    page_.put("${}{} << END\n{} 0\n", name, planner, axis.least);
    for (std::size_t i = 0; i < values.size(); ++i) {
      page_.put("{} {}\n", values[i] * axis.unit, percent(i + 1));
    }
    page_.put("{} {}\nEND\n${}_marks{} << END\n", axis.greatest, percent(values.size()), name,
              planner);
    for (const double share : kMarkedShares) {
      if (values.empty()) break;
      const auto rank = std::ceil(share * static_cast<double>(values.size()));
      const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
      page_.put("{} {}\n", values[index] * axis.unit, percent(index + 1));
    }
    page_.put("END\n");
  }

  void put_panel(int column, int row, const PlotAxis& x, const PlotAxis& y) {
    page_.put_panel({kLeft + column * kColumn, kBottom + row * kRow, kPanelWidth, kPanelHeight}, x,
                    y);
  }

  void put_plot(std::string_view data, std::string_view columns) {
    page_.put("plot NaN notitle");
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      if (lengths_[i].empty()) continue;
      page_.put(", \\\n  ${}{} {} with points {} notitle", data, i, columns, page_.point_look(i));
    }
    page_.put("\n");
  }

  void put_distributions(std::string_view name) {
    page_.put("plot NaN notitle");
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      if (lengths_[i].empty()) continue;
      page_.put(", \\\n  ${}{} using 1:2 with steps {} notitle", name, i, page_.line_look(i));
      page_.put(", \\\n  ${}_marks{} using 1:2 with points {} notitle", name, i,
                page_.point_look(i));
    }
    page_.put("\n");
  }

  std::vector<std::string> planners_;
  PlotPage page_;
  std::size_t queries_;
  std::vector<Values> lengths_;
  std::vector<Values> times_;
  std::vector<Values> expansions_;
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
