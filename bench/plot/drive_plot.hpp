#pragma once

// Drives as a picture, drawn by gnuplot (5.4 or later): speed, heading error and cross-track error
// over time, a line for each controller. The script holds its data and writes the picture to standard
// output, as that of comparison_plot.hpp does.

#include <span>
#include <string>

#include "bench/plot/plot_style.hpp"
#include "wend/report/drive_report.hpp"

namespace wend {

/// The text of the script. O(samples).
std::string drive_plot(std::span<const ControlledDrive> drives, PlotKind kind,
                       const PlotColours& colours = kLightPlot);

}  // namespace wend
