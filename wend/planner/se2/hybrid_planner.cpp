#include "wend/planner/se2/hybrid_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/geometry/compass.hpp"
#include "wend/planner/failure_causes.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/lattice/query_ends.hpp"
#include "wend/planner/se2/rest_of_drive.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend {
namespace {

DriveKind model_of(const HybridAStarOptions& options) {
  const bool car = options.motion_model == DriveKind::reeds_shepp;
  return car && !options.allow_reverse ? DriveKind::dubins : options.motion_model;
}

Steering steering_for(const FreeSpace& space, const HybridAStarOptions& options) {
  const double resolution = space.map().frame().resolution;
  return {model_of(options),
          options.turning_radius / resolution,
          {.reverse = options.reverse_factor,
           .turn = options.turn_factor,
           .gear_change = options.gear_change_cost / resolution,
           .spin = options.turn_cost / resolution}};
}

HybridResolution resolution_for(const FreeSpace& space, const Steering& steering,
                                const HybridAStarOptions& options) {
  const double metre = 1 / space.map().frame().resolution;
  // In a room that is small beside the turning circle, motions are as long as the room allows.
  constexpr double kParts = 8;
  const double room = std::max(space.width(), space.height()) / kParts;
  const double automatic =
      steering.radius() > 0 ? std::min(steering.radius() / 2, room) : 0.2 * metre;
  HybridResolution resolution;
  resolution.step =
      options.motion_length > 0 ? options.motion_length * metre : std::max(1.0, automatic);
  resolution.position = resolution.step / 2;
  resolution.headings = static_cast<int>(options.headings);
  resolution.wide_room = 2.5 * resolution.step;
  resolution.trace_spacing = 5 * resolution.step;
  resolution.weight = options.weight;
  return resolution;
}

constexpr double kLongestTurn = kPi / 2;  // of a motion between two poses of a path
constexpr double kRounding = 1e-9;

}  // namespace

HybridPlanner::HybridPlanner(const FreeSpace& space, const HybridAStarOptions& options)
    : HybridPlanner(space, options, std::make_shared<const HybridGround>(space)) {}

HybridPlanner::HybridPlanner(FreeSpace space, const HybridAStarOptions& options,
                             std::shared_ptr<const HybridGround> ground)
    : Planner(std::move(space)),
      options_(options),
      steering_(steering_for(free_space(), options)),
      ground_(std::move(ground)),
      ring_(std::make_shared<GoalRing>(steering_)) {}

std::unique_ptr<Planner> HybridPlanner::do_clone() const {
  return std::unique_ptr<HybridPlanner>(new HybridPlanner(free_space(), options_, ground_));
}

std::optional<Error> HybridPlanner::do_update(const SpaceChange& /*change*/) {
  HybridPlanner::do_release();
  const double radius = steering_.radius();
  steering_ = steering_for(free_space(), options_);
  if (steering_.radius() != radius) ring_ = std::make_shared<GoalRing>(steering_);
  ground_ = std::make_shared<const HybridGround>(free_space());
  return std::nullopt;
}

void HybridPlanner::do_release() {
  shortener_.reset();
  search_.reset();
  ground_.reset();
}

std::optional<Status> HybridPlanner::do_check(const Query& query) {
  if (!(std::abs(query.start.heading) <= kLargestHeading)) return Status::unsupported_query;
  if (!cell_under(free_space(), query.start.point())) return Status::start_outside;
  if (!free_space().fits(query.start)) return Status::start_blocked;
  goals_.clear();
  std::size_t index = 0;
  return take_goals(query, [&](const Goal& /*goal*/) { return take_goal(query, index++); });
}

std::optional<Status> HybridPlanner::take_goal(const Query& query, std::size_t index) {
  const Goal& goal = query.goals[index];
  if (goal.heading && !(std::abs(*goal.heading) <= kLargestHeading)) {
    return Status::unsupported_query;
  }
  auto place = place_for(goal, cell_at(query.start.point()));
  if (!place) {
    if (place_for(goal)) return Status::unreachable;
    return cell_under(free_space(), goal.point) ? Status::goal_blocked : Status::goal_outside;
  }
  place->index = index;
  goals_.push_back(*place);
  return std::nullopt;
}

/// A heading of a goal with which the robot fits at a point.
std::optional<double> HybridPlanner::heading_at(Point point, const Goal& goal) const {
  const double wanted = goal.heading.value_or(0);
  if (free_space().fits({point.x, point.y, wanted})) return wanted;
  const double most = goal.heading ? std::min(goal.heading_tolerance, kPi) : kPi;
  constexpr int kChoices = 18;  // to each side
  for (int i = 1; i <= kChoices; ++i) {
    for (const int side : {1, -1}) {
      const double heading = wrapped_angle(wanted + side * most * i / kChoices);
      if (free_space().fits({point.x, point.y, heading})) return heading;
    }
    if (most == 0 || !free_space().outline()) break;
  }
  return std::nullopt;
}

/// The nearest place to a goal, within its tolerance, where the robot fits; of those that are connected with a cell, if
/// one is given.
std::optional<HybridGoal> HybridPlanner::place_for(const Goal& goal,
                                                   const std::optional<Cell>& from) const {
  if (!is_near_a_map(goal)) return std::nullopt;
  const auto counts = [&](Point point) {
    return !from || ground_->connected(*from, cell_at(point));
  };
  const auto place_at = [&](Point point, double heading) {
    return HybridGoal{{point.x, point.y, heading}, !goal.heading, goal, 0};
  };
  if (cell_under(free_space(), goal.point) && counts(goal.point)) {
    if (const auto heading = heading_at(goal.point, goal)) return place_at(goal.point, *heading);
  }
  std::optional<HybridGoal> nearest;
  GoalRegion(goal, std::nullopt, cells_of(free_space())).for_each([&](Cell cell) {
    const Point point = centre_of(cell);
    if (nearest && distance(goal.point, point) >= distance(goal.point, nearest->pose.point()))
      return;
    if (!counts(point)) return;
    if (const auto heading = heading_at(point, goal)) nearest = place_at(point, *heading);
  });
  return nearest;
}

std::optional<Point> HybridPlanner::do_nearest_free(const Goal& goal) const {
  if (!is_near_a_map(goal)) return std::nullopt;
  if (place_for(goal)) return goal.point;
  const PlaceGrid cells = cells_of(free_space());
  const auto cell =
      nearest_accepted(cells.columns, cells.rows, cells.nearest(goal.point), [&](Cell at) {
        return free_space().possible()[at] && heading_at(centre_of(at), goal).has_value();
      });
  if (!cell) return std::nullopt;
  return centre_of(*cell);
}

std::optional<Pose> HybridPlanner::do_place_of(const Pose& pose) const {
  if (!std::isfinite(pose.heading) || !cell_under(free_space(), pose.point())) return std::nullopt;
  return pose;
}

/// Straight ahead and back, and what the robot has besides: arcs of its radius up to a quarter turn, turns in place by
/// tens of degrees, moves to the sides.
std::vector<LeavingMotion> HybridPlanner::do_motions_from(const Pose& place, double most) const {
  constexpr double kQuarter = kPi / 2;
  const DriveKind model = steering_.model();
  std::vector<LeavingMotion> motions;
  const auto add = [&](const Motion& motion, bool ends_anywhere) {
    motions.push_back({{segment_of(place, motion)}, ends_anywhere});
  };
  for (const int gear : {1, -1}) {
    if (gear < 0 && model == DriveKind::dubins) break;
    add({gear * most, 0, 0}, true);
    if (model == DriveKind::reeds_shepp || model == DriveKind::dubins) {
      const double turn = std::min(most / steering_.radius(), kQuarter);
      for (const int side : {1, -1}) add({gear * turn * steering_.radius(), side * turn}, true);
    }
    if (model == DriveKind::omni) add({most, 0, gear * kQuarter}, true);
  }
  if (model != DriveKind::differential && model != DriveKind::omni) return motions;
  constexpr int kTurns = 9;  // to each side, up to a quarter turn
  for (int i = 1; i <= kTurns; ++i) {
    for (const int side : {1, -1}) add({0, side * kQuarter * i / kTurns}, false);
  }
  return motions;
}

Status HybridPlanner::do_plan(const Query& query, Plan& out) {
  if (!search_) {
    constexpr double kSpacing = 4;  // of the poses between which a drive is shortened, in steps
    const HybridResolution resolution = resolution_for(free_space(), steering_, options_);
    search_ = std::make_unique<HybridPortfolio>(
        ground_, steering_, resolution, HybridBudget{.seconds = options_.time_budget}, ring_);
    shortener_ =
        std::make_unique<DriveShortener>(ground_->check(), steering_, kSpacing * resolution.step);
  }
  const SearchOutcome outcome = search_->run(query.start, goals_, query.limits, query.observer);
  out.metrics = search_->metrics();
  // A limit ends the search for a better path, not the path that there is.
  const HybridSearch* const finder = search_->finder();
  if (finder == nullptr || outcome == SearchOutcome::cancelled) return status_of(outcome);
  write(query, *finder, out);
  return Status::found;
}

void HybridPlanner::write(const Query& query, const HybridSearch& finder, Plan& out) {
  finder.write_path(drive_);
  join(drive_);
  shortener_->shorten(drive_);
  out.path.drive_to(query.start);
  for (const DrivenMotion& driven : drive_) {
    const double turn = std::abs(driven.motion.turn);
    const auto parts = std::max(1, static_cast<int>(std::ceil(turn / kLongestTurn - kRounding)));
    for (int i = 1; i <= parts; ++i) {
      const Motion before = part_of(driven.motion, static_cast<double>(i) / parts);
      out.path.drive_to(pose_after(driven.from, before));
    }
  }
  out.cost = cost_of(drive_, ground_->check(), steering_);
  name_moves(out);
  out.goal_snapping_error =
      snapping_error_between(query.goals[finder.goal()], out.path.driven_poses().back());
}

void HybridPlanner::name_moves(Plan& plan) const {
  const auto poses = plan.path.driven_poses();
  const Frame& frame = free_space().map().frame();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    plan.moves.push_back(name_of(segment_between(poses[i - 1], poses[i]), frame));
  }
}

std::optional<Plan> HybridPlanner::do_rest_of(const Path& path, const Query& query,
                                              std::size_t& passed) const {
  if (!path.driven()) return std::nullopt;
  const PlaceOnDrive place =
      nearest_on_drive(JoinedPoses(path.driven_poses()), query.start, passed);
  auto rest = rest_of_drive(path.driven_poses(), place, query.start, ground_->check(), steering_);
  if (!rest) return std::nullopt;
  passed = place.joint;
  Plan plan;
  plan.path = std::move(rest->path);
  plan.cost = rest->cost;
  name_moves(plan);
  return plan;
}

double HybridPlanner::do_heuristic(const Pose& pose) const {
  if (!search_ || !cell_under(free_space(), pose.point())) return 0;
  return search_->heuristic(pose);
}

std::uint64_t HybridPlanner::do_state_count() const {
  return free_space().possible().count() * static_cast<std::uint64_t>(options_.headings);
}

/// What the last run has learned, if it was of this query.
NoDriveFound HybridPlanner::why_no_drive(const Query& query) const {
  const Goal& goal = query.goals.front();
  const bool parted = place_for(goal) && !place_for(goal, cell_at(query.start.point()));
  NoDriveFound why = parted    ? NoDriveFound{.why = NoDriveFound::Why::parted}
                     : search_ ? search_->no_drive()
                               : NoDriveFound{};
  const double resolution = free_space().map().frame().resolution;
  why.disc_radius = free_space().footprint().inner_disc().radius / resolution;
  return why;
}

std::optional<FailureCause> HybridPlanner::why_no_place(std::size_t index, const Goal& goal) const {
  if (place_for(goal)) return std::nullopt;
  if (!cell_under(free_space(), goal.point)) return EndOutside{index};
  const Pose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  auto cause = why_blocked(free_space(), index, pose);
  if (cause) cause = at_headings(*std::move(cause), goal, free_space());
  return cause;
}

std::vector<FailureCause> HybridPlanner::do_failure(const Query& query, Status status) const {
  switch (status) {
    case Status::unsupported_query:
      return {wrong_heading(query, kLargestHeading, InvalidQuery::Fault::large_heading)};
    case Status::start_outside:
      return {EndOutside{}};
    case Status::start_blocked:
      return {why_blocked(free_space(), {}, query.start).value_or(EndBlocked{})};
    case Status::goal_outside:
    case Status::goal_blocked:
      return causes_of_goals(query, [&](std::size_t i) { return why_no_place(i, query.goals[i]); });
    case Status::unreachable:
      return {why_no_drive(query)};
    case Status::time_limit:
      if (std::isfinite(query.limits.seconds)) return {};
      return {OwnLimit{"hybrid_astar", "time_budget", options_.time_budget}};
    default:
      return {};
  }
}

}  // namespace wend
