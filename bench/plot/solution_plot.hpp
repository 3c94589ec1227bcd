#pragma once

// The paths of an anytime planner as a picture, drawn by gnuplot (5.4 or later): the cost of the best path and the
// proven lower bound, over time. The script holds its data and writes the picture to standard output.

#include <span>
#include <string>

#include "bench/plot/plot_style.hpp"
#include "wend/report/plan_report.hpp"

namespace wend {

/// The text of the script; there is at least one path. O(paths).
std::string solution_plot(std::span<const TimedSolution> solutions, PlotKind kind,
                          const PlotColours& colours = kLightPlot);

}  // namespace wend
