#include "wend/planner/lattice/car_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/planner/lattice/car_reason.hpp"
#include "wend/planner/search_status.hpp"
#include "wend/space/lattice/car_path.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

SnappingError snapping_error_between(const Goal& asked, const Pose& taken) {
  const double turn = asked.heading ? normalized_angle(*asked.heading - taken.heading) : 0;
  return {distance(asked.point, taken.point()), std::abs(turn)};
}

}  // namespace

std::int64_t unit_for(double turning_radius, const Frame& frame) {
  constexpr double kMost = 1e6;
  constexpr double kRounding = 1e-9;
  const double cells = turning_radius / frame.resolution * (1 - kRounding);
  return static_cast<std::int64_t>(std::clamp(std::ceil(cells), 1.0, kMost));
}

std::string why_no_lattice(const GridMap& map, const CarDriving& driving) {
  const std::string size =
      std::to_string(map.width()) + " x " + std::to_string(map.height()) + " cells";
  if (!has_room_for(map, driving)) {
    return "the map of " + size + " is too small for a lattice_resolution of " +
           std::to_string(driving.unit);
  }
  if (!CarSpace<RealCarCosts>::can_number(map, driving)) {
    return "the map of " + size +
           " has too many lattice vertices for the car planner: choose a larger lattice_resolution";
  }
  return {};
}

CarPlanner::CarPlanner(FreeSpace space, const CarOptions& options)
    : Planner(std::move(space)), options_(options) {
  make();
}

void CarPlanner::make() {
  engine_.reset();  // its memory first
  lattice_.reset();
  if (!why_no_lattice(free_space().map(), options_.driving).empty()) return;
  lattice_ = std::make_unique<CarLattice>(free_space(), options_.driving);
  engine_ = make_car_engine(*lattice_, options_.heuristic, options_.weight);
}

std::optional<Status> CarPlanner::do_check(const Query& query) {
  if (!lattice_) return Status::unsupported_map;
  if (!std::isfinite(query.start.heading)) return Status::unsupported_query;
  const auto start = place_on(*lattice_, query.start);
  if (!start) return Status::start_outside;
  if (!lattice_->passable(start->corner)) return Status::start_blocked;
  asked_start_ = query.start;
  start_ = *start;
  goals_.clear();
  asked_goals_.clear();
  std::optional<Status> why_none;  // of the first goal
  for (const Goal& goal : query.goals) {
    const auto failed = take_goal(goal);
    if (failed && !why_none) why_none = failed;
  }
  if (goals_.empty()) return why_none;
  return std::nullopt;
}

std::optional<Status> CarPlanner::take_goal(const Goal& goal) {
  if (goal.heading && !std::isfinite(*goal.heading)) return Status::unsupported_query;
  const auto place = place_on(*lattice_, {goal.point.x, goal.point.y, goal.heading.value_or(0)});
  if (!place) return Status::goal_outside;
  if (!lattice_->passable(place->corner)) return Status::goal_blocked;
  if (!lattice_->connected(start_.corner, place->corner)) return Status::unreachable;
  goals_.push_back({place->corner, std::nullopt});
  if (goal.heading) goals_.back().heading = place->heading;
  asked_goals_.push_back(goal);
  return std::nullopt;
}

Status CarPlanner::do_plan(const Query& query, Plan& out) {
  engine_->begin(start_, goals_, query.limits, query.observer);
  return finish(engine_->run(), out);
}

std::optional<Status> CarPlanner::do_begin(const Query& query, Plan& out) {
  limits_ = query.limits;
  engine_->begin(start_, goals_, limits_, query.observer);
  out.metrics = engine_->metrics();
  return std::nullopt;
}

std::optional<Status> CarPlanner::do_step(Plan& out) {
  const SearchOutcome outcome = engine_->step();
  out.metrics = engine_->metrics();
  if (outcome == SearchOutcome::running) return std::nullopt;
  return finish(outcome, out);
}

Status CarPlanner::finish(SearchOutcome outcome, Plan& out) {
  out.metrics = engine_->metrics();
  if (outcome != SearchOutcome::found) return status_of(outcome);
  engine_->write_path(out.path);
  drive_.clear();
  for (const Pose& pose : out.path.driven_poses()) {
    if (const auto place = lattice_->nearest(pose)) drive_.push_back(*place);
  }
  for (std::size_t i = 1; i < drive_.size(); ++i) {
    const auto move = move_between(drive_[i - 1], drive_[i], lattice_->y_up());
    if (move) out.moves.push_back(to_string(*move));
  }
  assert(drive_.size() == out.path.size() && out.moves.size() + 1 == drive_.size());
  out.cost = car_path_cost(*lattice_, drive_);
  out.bound = options_.bound();
  const auto reached = std::find_if(goals_.begin(), goals_.end(), [&](const CarGoal& goal) {
    return goal.contains(drive_.back());
  });
  out.start_snapping_error =
      snapping_error_between(asked_start_, lattice_->to_grid(drive_.front()));
  out.goal_snapping_error =
      snapping_error_between(asked_goals_[static_cast<std::size_t>(reached - goals_.begin())],
                             lattice_->to_grid(drive_.back()));
  return Status::found;
}

OpenList CarPlanner::do_open_list(std::size_t most) const {
  return engine_ == nullptr ? OpenList{} : engine_->open_list(most);
}

std::string CarPlanner::do_reason(const Query& query, Status status) const {
  if (status == Status::unsupported_map) {
    return why_no_lattice(free_space().map(), options_.driving);
  }
  return lattice_ ? car_reason(*lattice_, query, status) : std::string();
}

double CarPlanner::do_heuristic(const Pose& pose) const {
  if (!lattice_) return 0;
  const auto place = place_on(*lattice_, pose);
  return place ? engine_->heuristic(*place) : 0;
}

std::uint64_t CarPlanner::do_state_count() const {
  return lattice_ ? lattice_->passable().count() * kHeadings : 0;
}

void CarPlanner::do_update(std::span<const Cell> /*changed*/) { make(); }

}  // namespace wend
