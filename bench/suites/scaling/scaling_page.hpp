#pragma once

// docs/performance.md: the measurements on growing maps, as tables and as a picture.

#include <string>
#include <vector>

#include "bench/plot/plot_style.hpp"
#include "bench/suites/scaling/scaling_run.hpp"

namespace wend::bench {

/// Markdown. `picture` is the plots' file, as seen from the page.
std::string scaling_page(const ScalingPlan& plan, const std::vector<MapScale>& maps,
                         const std::string& picture);

/// A gnuplot script: a query's time, memory and the build time of indexes against the map's cells.
std::string scaling_plot(const ScalingPlan& plan, const std::vector<MapScale>& maps, PlotKind kind);

}  // namespace wend::bench
