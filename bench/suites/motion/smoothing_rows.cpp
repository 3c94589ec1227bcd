#include <fmt/format.h>

#include <utility>

#include "bench/suites/motion/motion_row.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/path/smoothing/curvature_smoother.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend::bench {
namespace {

constexpr int kSide = 2000;
constexpr std::size_t kPoints = 1000;
constexpr double kSmoothingBar = 1e-3;  // seconds, of a safe one

/// A map, a robot and the first 1000 cells of a long path, as A* finds it.
struct Walk {
  std::string kind;  // the generator
  std::string name;
  FreeSpace space;
  Path path;
};

Walk walk_on(std::string name, const std::string& kind, const OptionValues& options,
             double radius_in_cells) {
  const GridMap map = generated_map(kind, kSide, kSide, options, 1);
  FreeSpace space = *make_free_space(
      map, {.footprint = Footprint::disc(radius_in_cells * map.frame().resolution)});
  constexpr int kBorder = 40;
  const auto start = nearest_passable(space, {kBorder, kBorder});
  if (!start) throw Wrong("there is no room on the map '" + name + "'");
  const auto goal = nearest_passable(space, {kSide - kBorder, kSide - kBorder}, start);
  if (!goal) throw Wrong("there is no goal on the map '" + name + "'");
  const auto plan = (*make_planner("astar", space))->plan(Query::between(*start, *goal));
  if (!plan || plan->path.size() < kPoints) throw Wrong("there is no long path on '" + name + "'");
  const auto cells = plan->path.cells().first(kPoints);
  return {kind, fmt::format("{}, radius {} cells", name, radius_in_cells), std::move(space),
          Path({cells.begin(), cells.end()})};
}

MotionRow smoothing(const Walk& walk, const GradientOptions& options, int rounds) {
  SmoothingResult smoothed;
  MotionRow row;
  row.name = (options.unsafe ? "smooth unsafely, " : "smooth, ") + walk.name;
  row.seconds =
      fastest(rounds, [&] { smoothed = smooth_by_gradient(walk.path, walk.space, options); });
  if (!smoothed) throw Wrong(smoothed.error().message);
  if (!options.unsafe) row.bar_seconds = kSmoothingBar;
  row.note = fmt::format("{} sweeps, {:.1f} % held", smoothed->sweeps, 100 * smoothed->held);
  return row;
}

MotionRow bounding(const Walk& walk, double radius, int rounds) {
  SmoothingResult smoothed;
  MotionRow row;
  row.name = fmt::format("bound turns to {} cells, {}", radius, walk.name);
  row.seconds = fastest(
      rounds, [&] { smoothed = smooth_by_curvature(walk.path, walk.space, {.radius = radius}); });
  if (!smoothed) throw Wrong(smoothed.error().message);
  row.note =
      fmt::format("{} sweeps{}", smoothed->sweeps, smoothed->within_bound ? "" : ", too tight");
  return row;
}

template <class Simplify>
MotionRow simplifying(const std::string& name, const Walk& walk, int rounds, Simplify&& simplify) {
  Path simple;
  MotionRow row;
  row.name = name + ", " + walk.name;
  row.seconds = fastest(rounds, [&] { simple = simplify(); });
  row.note = fmt::format("{} points", simple.size());
  return row;
}

}  // namespace

std::vector<MotionRow> smoothing_rows(int rounds) {
  std::vector<Walk> walks;
  walks.push_back(walk_on("open", "random", {{"density", "0.001"}}, 0));
  walks.push_back(walk_on("open", "random", {{"density", "0.001"}}, 3));
  walks.push_back(walk_on("office", "office", {}, 0));
  walks.push_back(walk_on("office", "office", {}, 2));
  walks.push_back(walk_on("office", "office", {}, 4));
  walks.push_back(walk_on("clutter of 33 %", "random", {{"density", "0.33"}}, 0));
  walks.push_back(walk_on("clutter of 10 %", "random", {{"density", "0.1"}}, 0.5));
  walks.push_back(walk_on("clutter of 1 %", "random", {{"density", "0.01"}}, 3));
  std::vector<MotionRow> rows;
  for (const Walk& walk : walks) {
    rows.push_back(smoothing(walk, {.unsafe = true}, rounds));
    rows.push_back(smoothing(walk, {}, rounds));
    if (walk.kind == "office") rows.push_back(bounding(walk, 3, rounds));
    rows.push_back(simplifying("pull taut", walk, rounds,
                               [&] { return *string_pulled(walk.path, walk.space); }));
    rows.push_back(simplifying("simplify to 0.5 cells", walk, rounds,
                               [&] { return *simplified(walk.path, 0.5, walk.space); }));
    rows.push_back(simplifying("resample at 0.5 cells", walk, rounds,
                               [&] { return *resampled(walk.path, 0.5, walk.space); }));
  }
  return rows;
}

}  // namespace wend::bench
