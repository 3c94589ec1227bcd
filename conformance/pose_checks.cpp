// Planners whose states have headings: what is true of their answers, whatever their motions are.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "conformance/answer.hpp"
#include "conformance/checks.hpp"
#include "conformance/driven_path.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"

namespace wend::test {
namespace {

constexpr double kNear = 1e-6;

/// Do these ends of a query and of a path lie as far apart as the plan says?
bool is_error_between(Point asked, std::optional<double> heading, const Pose& taken,
                      const SnappingError& claimed) {
  const double distance = std::hypot(asked.x - taken.x, asked.y - taken.y);
  const double turn =
      heading ? std::abs(std::remainder(*heading - taken.heading, 2 * std::numbers::pi)) : 0;
  return std::abs(distance - claimed.distance) <= kNear && std::abs(turn - claimed.turn) <= kNear;
}

/// Is the end as near to a goal as its tolerance allows, or as the nearest pose of a lattice may be?
bool is_within_tolerance(const SnappingError& error, const Goal& goal, double spacing) {
  const double away = std::max(goal.tolerance, spacing * std::numbers::sqrt2);
  const double turned = std::max(goal.heading_tolerance, std::numbers::pi / 4);
  return error.distance <= away + kNear && error.turn <= turned + kNear;
}

void hold_to_its_ends(Examination& examination, const Plan& plan, const Query& query,
                      double spacing) {
  const auto poses = plan.path.driven_poses();
  const auto says = [](const Pose& pose, const SnappingError& error) {
    return fmt::format("({},{},{}), errors {} cells and {} rad", pose.x, pose.y, pose.heading,
                       error.distance, error.turn);
  };
  if (!is_error_between(query.start.point(), query.start.heading, poses.front(),
                        plan.start_snapping_error)) {
    examination.violate("a path from the start, within its snapping errors",
                        says(poses.front(), plan.start_snapping_error));
  }
  const bool ends_in_a_goal = std::ranges::any_of(query.goals, [&](const Goal& goal) {
    return is_error_between(goal.point, goal.heading, poses.back(), plan.goal_snapping_error) &&
           is_within_tolerance(plan.goal_snapping_error, goal, spacing);
  });
  if (ends_in_a_goal) return;
  examination.violate("a path to a goal, within its tolerance and snapping errors",
                      says(poses.back(), plan.goal_snapping_error));
}

/// Places the robot all along the path, by code of the suite's own.
void hold_to_places(Examination& examination, const Plan& plan, const Query& query,
                    const FreeSpace& space) {
  const auto snapped = [](const SnappingError& error) {
    return std::max(error.distance, error.turn);
  };
  const double snapping =
      std::max(snapped(plan.start_snapping_error), snapped(plan.goal_snapping_error));
  const DriveReport report = checked_drive(
      space, plan.path, query,
      {.turns_in_place = true, .moves_aside = true, .end_tolerance = snapping + kNear});
  if (!report.fault.empty()) {
    examination.violate("a path along which the robot fits", "one that " + report.fault);
  }
}

void hold_to_its_poses(Examination& examination, const Plan& plan, const Query& query,
                       const FreeSpace& space, double spacing) {
  const auto poses = plan.path.driven_poses();
  if (poses.empty()) return examination.violate("a path of poses", "one without poses");
  hold_to_its_ends(examination, plan, query, spacing);
  if (const auto collision = first_collision(plan.path, space)) {
    examination.violate("a path without collisions",
                        fmt::format("at ({},{}) it {}", collision->point.x, collision->point.y,
                                    describe(collision->kind)));
  }
  hold_to_places(examination, plan, query, space);
  const std::string says = fmt::format("cost {}, bound {}", plan.cost, plan.bound);
  if (!(plan.cost >= 0 && plan.cost < kInfinite && plan.bound >= 1)) {
    examination.violate("a finite cost, and a bound of at least 1", says);
  }
  if (examination.info().guarantee == Guarantee::optimal && !plan.optimal()) {
    examination.violate("bound 1, as it declares to be optimal", says);
  }
  if (!plan.moves.empty() && plan.moves.size() + 1 != poses.size()) {
    examination.violate("one move fewer than poses, or none",
                        fmt::format("{} moves, {} poses", plan.moves.size(), poses.size()));
  }
}

void hold_to_its_reason(Examination& examination, const Answer& answer, const Query& query,
                        const GridMap& map) {
  if (const auto leftover = leftover_of(answer.plan); !leftover.empty()) {
    examination.violate("a failure without a path, at infinite cost", leftover);
  }
  const std::string came(to_string(answer.status));
  const Status status = answer.status;
  const bool outside = query.start.x < 0 || query.start.y < 0 || query.start.x > map.width() ||
                       query.start.y > map.height();
  if (outside != (status == Status::start_outside)) {
    return examination.violate(
        outside ? "start_outside" : "another status: the start is on the map", came);
  }
  constexpr std::array kReasons{Status::start_outside, Status::start_blocked, Status::goal_outside,
                                Status::goal_blocked, Status::unreachable};
  const bool gave_up =
      status == Status::step_limit && examination.info().guarantee == Guarantee::none;
  if (std::ranges::find(kReasons, status) == kReasons.end() && !gave_up) {
    examination.violate("a path, or a reason on the map", came);
  }
}

}  // namespace

void examine_pose_answers(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    const Query query = random_pose_query(random, trial.map);
    examination.ask(query);
    const Answer answer = answer_of(*planner, query);
    if (answer.status == Status::found) {
      examination.count_found();
      hold_to_its_poses(examination, answer.plan, query, planner->free_space(),
                        planner->place_grid().spacing);
      const SearchMetrics& metrics = answer.plan.metrics;
      // An anytime planner may expand a state again.
      if (metrics.generated < metrics.expanded && !planner->anytime()) {
        examination.violate("every expanded state generated before",
                            "fewer generated than expanded");
      }
    } else {
      hold_to_its_reason(examination, answer, query, trial.map);
    }
  }
}

}  // namespace wend::test
