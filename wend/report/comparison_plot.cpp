#include "wend/report/comparison_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "wend/report/comparison_measures.hpp"

namespace wend {
namespace {

constexpr double kLogarithmicFrom = 100;                         // greatest / least
constexpr std::array kShapes{7, 5, 9, 13, 11, 6, 4, 8, 12, 10};  // gnuplot's point types
constexpr std::array kMarkedShares{0.1, 0.3, 0.5, 0.7, 0.9};     // of a cumulative distribution

constexpr int kLine = 2;  // width

// In pixels.
constexpr double kWidth = 1400;
constexpr double kPanelWidth = 540;
constexpr double kPanelHeight = 380;
constexpr double kLeft = 125;
constexpr double kColumn = 700;  // from one panel to the next
constexpr double kRow = 495;
constexpr double kBottom = 95;
constexpr double kTitle = 65;
constexpr double kLegendRow = 26;
constexpr double kLegendWidth = 1300;
constexpr double kLetter = 9.7;  // of a name in the legend
constexpr double kMark = 62;     // of an entry, with the space around it

/// One planner's value of a measure for each query that it solved.
using Values = std::vector<double>;

std::string hex(std::uint32_t rgb) { return fmt::format("'#{:06x}'", rgb); }

/// A text in gnuplot's single quotes, on one line.
std::string quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    const bool is_control = static_cast<unsigned char>(letter) < ' ';
    if (letter == '\'') quoted += '\'';
    quoted += is_control ? ' ' : letter;
  }
  return quoted + "'";
}

struct Axis {
  std::string label;
  double unit = 1;  // times this a value of the measure is in the label's unit
  std::string format = "%g";
  bool logarithmic = false;
  double least = 0;
  double greatest = 1;
};

enum class Scale { linear, any };

/// From 0, or from decade to decade.
void fit(Axis& axis, Scale scale, const std::vector<Values>& planners) {
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
Axis time_axis(const std::vector<Values>& microseconds) {
  Values all;
  for (const Values& values : microseconds) all.insert(all.end(), values.begin(), values.end());
  const double median = summary_of(std::move(all)).median;
  if (median >= 1e6) return {.label = "time, s", .unit = 1e-6};
  if (median >= 1e3) return {.label = "time, ms", .unit = 1e-3};
  return {.label = "time, µs"};
}

/// What gnuplot's terminals call by the same name has not the same size in all of them.
struct Terminal {
  std::string_view name;
  double pixels_per_unit;
  int font;
  int headline_font;
  double mark;
};

Terminal terminal_for(PlotKind kind) {
  switch (kind) {
    case PlotKind::svg:
      return {"svg", 1, 17, 20, 0.55};
    case PlotKind::pdf:
      return {"pdfcairo", 125, 13, 15, 0.55};
    case PlotKind::png:
      break;
  }
  return {"pngcairo", 1, 13, 15, 0.9};
}

class PlotScript {
 public:
  PlotScript(const Comparison& comparison, PlotKind kind, const PlotColours& colours)
      : terminal_(terminal_for(kind)),
        planners_(planners_of(comparison)),
        colours_(colours),
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
    put_page();
    for (std::size_t i = 0; i < planners_.size(); ++i) put_data(i);
    put("unset key\nset multiplot\n");
    put_panel(0, 1, length_, time_);
    put_legend();
    put_plot("points", "using 1:2");
    put("unset label\n");
    put_panel(1, 1, length_, expansion_);
    put_plot("points", "using 1:3");
    const Axis share{.label = "queries solved, %", .greatest = 100};
    put_panel(0, 0, time_, share);
    put_distributions("time");
    put_panel(1, 0, expansion_, share);
    put_distributions("expansions");
    put("unset multiplot\n");
    return std::move(text_);
  }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  double height() const {
    return kBottom + kRow + kPanelHeight + kLegendRow * legend_rows() + kTitle;
  }

  double legend_column() const {
    std::size_t longest = 1;
    for (const std::string& planner : planners_) longest = std::max(longest, planner.size());
    return static_cast<double>(longest) * kLetter + kMark;
  }

  std::size_t legend_columns() const {
    const auto columns = static_cast<std::size_t>(kLegendWidth / legend_column());
    return std::clamp(columns, std::size_t{1}, std::max(planners_.size(), std::size_t{1}));
  }

  double legend_rows() const {
    return std::ceil(static_cast<double>(planners_.size()) / static_cast<double>(legend_columns()));
  }

  void put_page() {
    const std::string page = hex(colours_.page);
    const std::string ink = hex(colours_.ink);
    const bool in_inches = terminal_.pixels_per_unit != 1;
    put("set encoding utf8\nset terminal {} noenhanced background {} font 'sans,{}' ",
        terminal_.name, page, terminal_.font);
    put("size {0:.{2}f}{3},{1:.{2}f}{3}\n", kWidth / terminal_.pixels_per_unit,
        height() / terminal_.pixels_per_unit, in_inches ? 2 : 0, in_inches ? "in" : "");
    put("set border 3 lw 1 lc rgb {}\nset tics nomirror out textcolor rgb {}\n", ink, ink);
    put("set grid lw 1 lt 1 lc rgb {}\nset style data points\n", hex(colours_.grid));
  }

  /// What the panels draw of one planner.
  void put_data(std::size_t planner) {
    put("$points{} << END\n", planner);
    for (std::size_t i = 0; i < lengths_[planner].size(); ++i) {
      put("{} {} {}\n", lengths_[planner][i], times_[planner][i] * time_.unit,
          expansions_[planner][i]);
    }
    put("END\n");
    put_distribution("time", planner, times_[planner], time_);
    put_distribution("expansions", planner, expansions_[planner], expansion_);
  }

  /// Steps from edge to edge of the panel, and some marks on them.
  void put_distribution(std::string_view name, std::size_t planner, Values values,
                        const Axis& axis) {
    std::sort(values.begin(), values.end());
    const auto percent = [this](std::size_t count) {
      return 100 * static_cast<double>(count) / static_cast<double>(queries_);
    };
    put("${}{} << END\n{} 0\n", name, planner, axis.least);
    for (std::size_t i = 0; i < values.size(); ++i) {
      put("{} {}\n", values[i] * axis.unit, percent(i + 1));
    }
    put("{} {}\nEND\n${}_marks{} << END\n", axis.greatest, percent(values.size()), name, planner);
    for (const double share : kMarkedShares) {
      if (values.empty()) break;
      const auto rank = std::ceil(share * static_cast<double>(values.size()));
      const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
      put("{} {}\n", values[index] * axis.unit, percent(index + 1));
    }
    put("END\n");
  }

  void put_panel(int column, int row, const Axis& x, const Axis& y) {
    const double left = kLeft + column * kColumn;
    const double bottom = kBottom + row * kRow;
    put("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", left / kWidth,
        (left + kPanelWidth) / kWidth);
    put("set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n", bottom / height(),
        (bottom + kPanelHeight) / height());
    put_axis('x', x);
    put_axis('y', y);
  }

  void put_axis(char name, const Axis& axis) {
    put("set {}label {} textcolor rgb {}\n", name, quoted(axis.label), hex(colours_.ink));
    put("{} logscale {}\n", axis.logarithmic ? "set" : "unset", name);
    put("set format {} '{}'\n", name, axis.format);
    put("set {}range [{}:{}]\n", name, axis.least, axis.greatest);
  }

  /// Above all panels, with a headline. It comes with every panel until the labels are unset.
  void put_legend() {
    const std::string ink = hex(colours_.ink);
    put("set label 'Planners on {} {}' at screen 0.5,{:.4f} center font ',{}' textcolor rgb {}\n",
        queries_, queries_ == 1 ? "query" : "queries", 1 - 26 / height(), terminal_.headline_font,
        ink);
    const std::size_t columns = legend_columns();
    const double left = (kWidth - legend_column() * static_cast<double>(columns) + kMark) / 2;
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      const std::size_t row = i / columns;
      const double x = left + legend_column() * static_cast<double>(i % columns);
      const double y = height() - kTitle - kLegendRow * static_cast<double>(row);
      put("set label {} at screen {:.4f},{:.4f} left offset 1.2,0 textcolor rgb {} point {}\n",
          quoted(planners_[i]), x / kWidth, y / height(), ink, look(i));
    }
  }

  std::string colour_of(std::size_t planner) const {
    return hex(colours_.planners[planner % colours_.planners.size()]);
  }

  std::string look(std::size_t planner) const {
    return fmt::format("pt {} ps {} lw {} lc rgb {}", kShapes[planner % kShapes.size()],
                       terminal_.mark, kLine, colour_of(planner));
  }

  void put_plot(std::string_view data, std::string_view columns) {
    put("plot NaN notitle");
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      if (lengths_[i].empty()) continue;
      put(", \\\n  ${}{} {} with points {} notitle", data, i, columns, look(i));
    }
    put("\n");
  }

  void put_distributions(std::string_view name) {
    put("plot NaN notitle");
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      if (lengths_[i].empty()) continue;
      put(", \\\n  ${}{} using 1:2 with steps lw {} lc rgb {} notitle", name, i, kLine,
          colour_of(i));
      put(", \\\n  ${}_marks{} using 1:2 with points {} notitle", name, i, look(i));
    }
    put("\n");
  }

  Terminal terminal_;
  std::vector<std::string> planners_;
  PlotColours colours_;
  std::size_t queries_;
  std::vector<Values> lengths_;
  std::vector<Values> times_;
  std::vector<Values> expansions_;
  Axis length_;
  Axis time_;
  Axis expansion_;
  std::string text_;
};

}  // namespace

std::string comparison_plot(const Comparison& comparison, PlotKind kind,
                            const PlotColours& colours) {
  return PlotScript(comparison, kind, colours).text();
}

}  // namespace wend
