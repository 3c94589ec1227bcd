#include "bench/suites/car/yard.hpp"

#include <utility>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

constexpr double kObstacleShare = 0.12;

Pose random_pose(Random& random, const FreeSpace& space) {
  const auto below = [&](int end) {
    return static_cast<int>(random.below(static_cast<std::uint64_t>(end)));
  };
  const Cell corner{below(space.width() + 1), below(space.height() + 1)};
  return pose_of({corner, kAllHeadings[random.below(kHeadings)]});
}

Query corner_to_corner(const FreeSpace& space) {
  return {pose_of({{0, 0}, Heading::plus_x}),
          {pose_of({{space.width(), space.height()}, Heading::plus_x})}};
}

/// Drives that the car can find.
std::vector<Query> drives_on(const FreeSpace& space, const YardPlan& plan) {
  const auto car = make_planner("car", space);
  std::vector<Query> drives;
  Random random(plan.seed);
  Query drive = corner_to_corner(space);
  while (drives.size() < plan.drives) {
    if ((*car)->plan(drive)) drives.push_back(drive);
    drive = {random_pose(random, space), {random_pose(random, space)}};
  }
  return drives;
}

Yard make_yard(const std::string& name, const std::string& kind, const OptionValues& options,
               const YardPlan& plan) {
  const auto map = make_map(kind, plan.size, plan.size, plan.seed, options);
  const FreeSpace space = *make_free_space(*map);
  return {name, space, drives_on(space, plan)};
}

}  // namespace

std::vector<Yard> make_yards(const YardPlan& plan) {
  const std::string cells =
      std::to_string(static_cast<int>(kObstacleShare * plan.size * plan.size));
  std::vector<Yard> yards;
  yards.push_back(make_yard("12 % obstacles", "car", {{"obstacles", cells}, {"rough", "0"}}, plan));
  yards.push_back(make_yard("12 % obstacles, 12 % rough", "car",
                            {{"obstacles", cells}, {"rough", cells}}, plan));
  yards.push_back(make_yard("parking", "parking", {}, plan));
  return yards;
}

}  // namespace wend::bench
