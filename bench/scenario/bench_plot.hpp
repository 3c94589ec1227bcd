#pragma once

// A benchmark as a picture, drawn by gnuplot (5.4 or later): time against the length of the path,
// the share of queries that was solved within a time, and, where there are maps of several sizes,
// the mean time against the map's size. The script holds its data: see comparison_plot.hpp.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/plot/plot_style.hpp"
#include "bench/scenario/bench_answer.hpp"

namespace wend {

/// The text of the script. Queries that a planner did not solve are not in its plots, and its share
/// of solved ones stays below 100 %. Beyond 2000 points per planner, some are left out evenly; the
/// distribution has all. O(n log n) in the answers.
std::string bench_plot(std::span<const BenchedMap> maps, PlotKind kind,
                       const PlotColours& colours = kLightPlot);

}  // namespace wend
