#pragma once

// A comparison of planners on many queries as a picture, drawn by gnuplot (5.4 or later): the time
// of a first and of a later query and expansions against the length of the path, and the share of
// queries that was solved within such a time and within a number of expansions. The legend says how
// long each planner was prepared. Axes are logarithmic where the values span decades.
//
// The script holds its data and writes the picture to standard output:
//
//   gnuplot compare.gnuplot > compare.png
//
// Planners differ in colour and in the shape of their marks.

#include <string>

#include "bench/comparison/comparison.hpp"
#include "bench/plot/plot_style.hpp"

namespace wend {

/// The text of the script. Queries that a planner did not solve are not in its plots, and its share
/// of solved ones stays below 100 %. O(n log n) in the rows.
std::string comparison_plot(const Comparison& comparison, PlotKind kind,
                            const PlotColours& colours = kLightPlot);

}  // namespace wend
