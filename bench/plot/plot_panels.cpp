#include "bench/plot/plot_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/measure/statistics.hpp"
#include "wend/base/thread_time.hpp"

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

}  // namespace

void fit(PlotAxis& axis, PlotScale scale, const std::vector<PlotValues>& values) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const PlotValues& some : values) {
    for (const double value : some) {
      least = std::min(least, value * axis.unit);
      greatest = std::max(greatest, value * axis.unit);
    }
  }
  if (greatest <= 0) return;
  axis.greatest = greatest * 1.05;
  if (scale == PlotScale::linear || least <= 0 || greatest / least < kLogarithmicFrom) return;
  axis.logarithmic = true;
  axis.least = std::pow(10, std::floor(std::log10(least)));
  axis.greatest = std::pow(10, std::ceil(std::log10(greatest)));
}

PlotAxis time_axis(const std::vector<PlotValues>& microseconds) {
  PlotValues all;
  for (const PlotValues& values : microseconds) all.insert(all.end(), values.begin(), values.end());
  std::erase_if(all, [](double value) { return std::isnan(value); });
  const double median = summary_of(std::move(all)).median;
  const std::string name(thread_time_name());
  if (median >= 1e6) return {.label = name + ", s", .unit = 1e-6};
  if (median >= 1e3) return {.label = name + ", ms", .unit = 1e-3};
  return {.label = name + ", µs"};
}

PlotRectangle panel_place(int column, int row) {
  return {kLeft + column * kColumn, kBottom + row * kRow, kPanelWidth, kPanelHeight};
}

double height_of_panels(int rows) { return kBottom + (rows - 1) * kRow + kPanelHeight; }

void put_distribution(PlotPage& page, std::string_view name, std::size_t planner, PlotValues values,
                      const PlotAxis& axis, std::size_t all) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  const auto percent = [all](std::size_t count) {
    return 100 * static_cast<double>(count) / static_cast<double>(all);
  };
  page.put("${}{} << END\n{} 0\n", name, planner, axis.least);
  for (std::size_t i = 0; i < values.size(); ++i) {
    page.put("{} {}\n", values[i] * axis.unit, percent(i + 1));
  }
  page.put("{} {}\nEND\n${}_marks{} << END\n", axis.greatest, percent(values.size()), name,
           planner);
  for (const double share : kMarkedShares) {
    if (values.empty()) break;
    const auto rank = std::ceil(share * static_cast<double>(values.size()));
    const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
    page.put("{} {}\n", values[index] * axis.unit, percent(index + 1));
  }
  page.put("END\n");
}

void plot_distributions(PlotPage& page, std::string_view name,
                        const std::vector<PlotValues>& planners) {
  page.put("plot NaN notitle");
  for (std::size_t i = 0; i < planners.size(); ++i) {
    if (planners[i].empty()) continue;
    page.put(", \\\n  ${}{} using 1:2 with steps {} notitle", name, i, page.line_look(i));
    page.put(", \\\n  ${}_marks{} using 1:2 with points {} notitle", name, i, page.point_look(i));
  }
  page.put("\n");
}

void plot_points(PlotPage& page, std::string_view data, std::string_view columns,
                 const std::vector<PlotValues>& planners) {
  page.put("plot NaN notitle");
  for (std::size_t i = 0; i < planners.size(); ++i) {
    if (planners[i].empty()) continue;
    page.put(", \\\n  ${}{} {} with points {} notitle", data, i, columns, page.point_look(i));
  }
  page.put("\n");
}

}  // namespace wend
