#include "bench/suites/car/reeds_shepp.hpp"

#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "wend/base/thread_time.hpp"

namespace wend::bench {
namespace {

namespace base = ompl::base;
namespace geometric = ompl::geometric;

constexpr double kTurningRadius = 1;
constexpr double kCheckedEvery = 0.1;  // cells along a curve

std::shared_ptr<base::ReedsSheppStateSpace> curves_on(const FreeSpace& space) {
  auto curves = std::make_shared<base::ReedsSheppStateSpace>(kTurningRadius);
  base::RealVectorBounds bounds(2);
  bounds.setLow(0);
  bounds.setHigh(0, space.width());
  bounds.setHigh(1, space.height());
  curves->setBounds(bounds);
  return curves;
}

base::PlannerPtr make(const std::string& name, const base::SpaceInformationPtr& information) {
  if (name == "RRT") return std::make_shared<geometric::RRT>(information);
  if (name == "KPIECE1") return std::make_shared<geometric::KPIECE1>(information);
  return std::make_shared<geometric::RRTConnect>(information);
}

bool is_free(const FreeSpace& space, const base::State* state) {
  const auto* pose = state->as<base::SE2StateSpace::StateType>();
  const Cell cell{std::min(static_cast<int>(pose->getX()), space.width() - 1),
                  std::min(static_cast<int>(pose->getY()), space.height() - 1)};
  return space.contains(cell) && !space.obstacles().blocked()[cell];
}

void put(const Pose& pose, base::ScopedState<base::SE2StateSpace>& state) {
  state->setXY(pose.x, pose.y);
  state->setYaw(pose.heading);
  state.enforceBounds();  // half a turn is -pi here
}

/// Adds what a drive took, if it was solved.
void drive(const FreeSpace& space, const Query& query, const std::string& planner, double seconds,
           ReedsSheppTiming& timing) {
  const auto curves = curves_on(space);
  geometric::SimpleSetup setup(curves);
  setup.setStateValidityChecker(
      [&space](const base::State* state) { return is_free(space, state); });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(kCheckedEvery /
                                                                  curves->getMaximumExtent());
  base::ScopedState<base::SE2StateSpace> start(curves);
  base::ScopedState<base::SE2StateSpace> goal(curves);
  put(query.start, start);
  put({query.goals.front().point.x, query.goals.front().point.y,
       query.goals.front().heading.value_or(0)},
      goal);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(make(planner, setup.getSpaceInformation()));
  setup.setup();
  const double begin = thread_cpu_seconds();
  const base::PlannerStatus status = setup.solve(seconds);
  const double took = thread_cpu_seconds() - begin;
  ++timing.drives;
  if (status != base::PlannerStatus::EXACT_SOLUTION) return;
  ++timing.solved;
  timing.seconds += took;
  timing.length += setup.getSolutionPath().length();
}

}  // namespace

void prepare_reeds_shepp(std::uint32_t seed) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  ompl::RNG::setSeed(seed);
}

std::vector<std::string> reeds_shepp_planners() { return {"RRTConnect", "RRT", "KPIECE1"}; }

ReedsSheppTiming time_reeds_shepp(const Yard& yard, const std::string& planner, double seconds) {
  ReedsSheppTiming timing{.planner = planner};
  for (const Query& query : yard.drives) drive(yard.space, query, planner, seconds, timing);
  if (timing.solved > 0) {
    timing.seconds /= static_cast<double>(timing.solved);
    timing.length /= static_cast<double>(timing.solved);
  }
  return timing;
}

}  // namespace wend::bench
