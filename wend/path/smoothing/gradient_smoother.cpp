#include "wend/path/smoothing/gradient_smoother.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "wend/path/smoothing/smoothing.hpp"

namespace wend {
namespace {

std::optional<std::string> fault_of(const GradientOptions& options) {
  if (!(options.epsilon >= 0 && std::isfinite(options.epsilon))) {
    return "epsilon must be finite and not negative";
  }
  if (!(options.max_distance >= 0)) return "max_distance must be at least 0";
  if (options.max_sweeps < 1) return "max_sweeps must be at least 1";
  return fault_of_weights(options.alpha, options.beta, options.in_place);
}

struct Sweep {
  double squared_change = 0;
  std::size_t held = 0;  // points that did not go all the way
};

Sweep sweep_over(const std::vector<Point>& path, MovablePath& moved, const GradientOptions& options,
                 StopCheck& stop) {
  const double alpha = options.alpha;
  const double beta = options.beta;
  Sweep sweep;
  Point before = path.front();
  for (std::size_t i = 1; i + 1 < path.size() && !stop.before_point(); ++i) {
    const Point at = moved.points()[i];
    const Point after = moved.points()[i + 1];
    const Point to{at.x + alpha * (path[i].x - at.x) + beta * (before.x + after.x - 2 * at.x),
                   at.y + alpha * (path[i].y - at.y) + beta * (before.y + after.y - 2 * at.y)};
    if (moved.move(i, to) < 1) ++sweep.held;
    const Point now = moved.points()[i];
    const double dx = now.x - at.x;
    const double dy = now.y - at.y;
    sweep.squared_change += dx * dx + dy * dy;
    before = options.in_place ? now : at;
  }
  return sweep;
}

Smoothed smoothed(const Path& path, MovablePath moved, const GradientOptions& options,
                  const StopSmoothing& stop) {
  const std::vector<Point> points = path.points();
  const double inner = points.size() < 3 ? 1 : static_cast<double>(points.size() - 2);
  StopCheck check(stop);
  Smoothed result;
  while (!result.converged && result.sweeps < static_cast<std::uint64_t>(options.max_sweeps)) {
    if (check.before_sweep()) break;
    const Sweep sweep = sweep_over(points, moved, options, check);
    if (check.stopped()) break;
    ++result.sweeps;
    result.converged = sweep.squared_change < options.epsilon || sweep.squared_change == 0;
    result.held = static_cast<double>(sweep.held) / inner;
  }
  result.stopped = check.stopped();
  moved.finish(result, path);
  return result;
}

}  // namespace

SmoothingResult smooth_by_gradient(const Path& path, const FreeSpace& space,
                                   const GradientOptions& options, const StopSmoothing& stop) {
  if (const auto fault = fault_of(options)) return failure(Status::invalid_option, *fault);
  auto movable = MovablePath::from(path, space, options);
  if (!movable) return Unexpected<Error>(std::move(movable).error());
  movable->bind(options.max_distance);
  return smoothed(path, *std::move(movable), options, stop);
}

SmootherInfo gradient_smoother() {
  return smoother_with<GradientOptions>(
      "gradient", "Gradient descent: keeps points near the path and near their neighbours",
      "Thrun 2012, Artificial Intelligence for Robotics", smooth_by_gradient);
}

}  // namespace wend
