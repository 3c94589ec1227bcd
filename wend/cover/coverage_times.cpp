#include "wend/cover/coverage_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

Grid<double> coverage_times(const Coverage& coverage, const FreeSpace& space, double tool_width) {
  const double resolution = space.map().frame().resolution;
  const double reach = tool_width / resolution / 2;
  Grid<double> times(space.width(), space.height(), std::numeric_limits<double>::infinity());
  double driven = 0;
  const auto pass = [&](const Line& line) {
    visit_cells_near(line, reach, times.width(), times.height(), [&](Cell cell) {
      if (coverage.wanted[cell]) times[cell] = std::min(times[cell], driven * resolution);
    });
    driven += line.length();
  };
  const std::vector<Point> points = coverage.path.points();
  if (points.size() == 1) pass({points.front(), points.front()});
  for (std::size_t i = 1; i < points.size(); ++i) {
    // Long lines in pieces as long as the tool is wide.
    const Line line{points[i - 1], points[i]};
    const int pieces = std::max(1, static_cast<int>(std::ceil(line.length() / (2 * reach))));
    for (int k = 0; k < pieces; ++k) {
      pass(
          {line.at(static_cast<double>(k) / pieces), line.at(static_cast<double>(k + 1) / pieces)});
    }
  }
  return times;
}

}  // namespace wend
