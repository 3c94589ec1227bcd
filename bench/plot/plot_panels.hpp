#pragma once

// What plot panels have in common: their places, axes that fit their values, points and cumulative
// distributions.

#include <string_view>
#include <vector>

#include "bench/plot/plot_page.hpp"

namespace wend {

/// One planner's values of a measure, one per query; NaN if there is none.
using PlotValues = std::vector<double>;

enum class PlotScale {
  linear,  // from 0
  any,     // logarithmic, from decade to decade, where the values span two of them
};

void fit(PlotAxis& axis, PlotScale scale, const std::vector<PlotValues>& values);

/// The axis of microseconds, in microseconds, milliseconds or seconds, so that the numbers are
/// neither small nor large.
PlotAxis time_axis(const std::vector<PlotValues>& microseconds);

/// Panels lie in two columns; row 0 is the lowest.
PlotRectangle panel_place(int column, int row);
double height_of_panels(int rows);

/// The data $<name><planner>: the share of `all` in percent below each value, as steps from edge to
/// edge of the panel, and $<name>_marks<planner>: some marks on them.
void put_distribution(PlotPage& page, std::string_view name, std::size_t planner, PlotValues values,
                      const PlotAxis& axis, std::size_t all);

/// Plots the distributions of those planners that have any values.
void plot_distributions(PlotPage& page, std::string_view name,
                        const std::vector<PlotValues>& planners);

/// Plots points $<data><planner> of those planners that have any values.
void plot_points(PlotPage& page, std::string_view data, std::string_view columns,
                 const std::vector<PlotValues>& planners);

}  // namespace wend
