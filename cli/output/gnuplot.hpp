#pragma once

// gnuplot, run as a program.

#include <string>

#include "bench/comparison/comparison_plot.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// The format that a file's extension names. Throws InputError if it is not a format of plots.
PlotKind plot_kind_of(const std::string& file);

PlotColours plot_colours_of(StyleName style);

/// Throws InputError if gnuplot is not installed.
void require_gnuplot();

/// The bytes that gnuplot writes for a script. Throws InputError with gnuplot's message.
std::string drawn_by_gnuplot(const std::string& script);

}  // namespace wend::cli
