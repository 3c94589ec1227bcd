#include "wend/planner/lattice/car_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/planner/lattice/car_priority.hpp"
#include "wend/planner/lattice/query_ends.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

struct CarNames {
  static CornerPose place(const CarState& state) { return state.place; }

  static void tell_place(SearchEvent& event, const auto& space, const CornerPose& place) {
    event.cell = corner_in_cells(space, place);
    event.heading = radians_of(place.heading);
  }
  static void tell_parent(SearchEvent& event, const auto& space, const CornerPose& place) {
    event.parent = corner_in_cells(space, place);
    event.parent_heading = radians_of(place.heading);
  }
  static void append(Path& path, const auto& space, const CornerPose& place) {
    path.drive_to(space.lattice().to_grid(place));
  }

 private:
  static Cell corner_in_cells(const auto& space, const CornerPose& place) {
    const int unit = space.lattice().unit();
    return {unit * place.corner.x, unit * place.corner.y};
  }
};

template <class Costs>
std::unique_ptr<CarEngine> engine_of(const CarLattice& lattice, CarHeuristic heuristic,
                                     double weight) {
  using Cost = typename Costs::Cost;
  using Engine = SearchEngineOf<CarEngine, CarNames, CarSpace<Costs>, CarFrontier<Cost>,
                                CarPriority<Costs>, DuplicateRule::keep_cheaper>;
  CarSpace<Costs> space(lattice);
  CarPriority<Costs> priority(space, heuristic, weight);
  return std::make_unique<Engine>(std::move(space), std::move(priority));
}

/// Is the lattice so large that even the estimates outgrow 32 bits?
bool too_far(const CarLattice& lattice) {
  constexpr int kFarthest = UINT32_MAX / CarUnits::kTurn / 4;
  return std::max(lattice.columns(), lattice.rows()) > kFarthest;
}

/// Without memory for its nodes it is not allocated().
std::unique_ptr<CarEngine> make_car_engine(const CarLattice& lattice, CarHeuristic heuristic,
                                           double weight) {
  if (weight == 0) heuristic = CarHeuristic::zero;
  const bool whole = has_whole_costs(lattice) && (weight == 1 || weight == 0);
  if (!whole) return engine_of<RealCarCosts>(lattice, heuristic, weight);
  const auto exact = [=] { return engine_of<ExactCarCosts>(lattice, heuristic, weight); };
  if (too_far(lattice)) return exact();
  return std::make_unique<WideningEngine<CarEngine>>(
      [=] { return engine_of<CompactCarCosts>(lattice, heuristic, weight); }, exact);
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
    : SearchPlanner(std::move(space)), options_(options) {
  CarPlanner::do_update({});
}

CarPlanner::CarPlanner(FreeSpace space, const CarOptions& options,
                       std::shared_ptr<const CarLattice> lattice)
    : SearchPlanner(std::move(space)), options_(options), lattice_(std::move(lattice)) {
  make_engine();
}

std::unique_ptr<Planner> CarPlanner::do_clone() const {
  return std::make_unique<CarPlanner>(free_space(), options_, lattice_);
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
  return take_goals(query, [this](const Goal& goal) { return take_goal(goal); });
}

std::optional<Status> CarPlanner::take_goal(const Goal& goal) {
  if (goal.heading && !std::isfinite(*goal.heading)) return Status::unsupported_query;
  const auto place = place_on(*lattice_, {goal.point.x, goal.point.y, goal.heading.value_or(0)});
  const PlaceGrid corners{.offset = 0,
                          .spacing = lattice_->unit(),
                          .columns = lattice_->columns(),
                          .rows = lattice_->rows()};
  CarRegion region{GoalRegion(goal, place ? std::optional(place->corner) : std::nullopt, corners)};
  Status why = region.corners.empty() ? Status::goal_outside : Status::goal_blocked;
  const bool reachable = region.corners.keep_if([&](Cell corner) {
    if (!lattice_->passable(corner)) return false;
    why = Status::unreachable;
    return lattice_->connected(start_.corner, corner);
  });
  if (!reachable) return why;
  if (goal.heading) {
    region.heading = nearest_heading(*goal.heading);
    region.headings = 0;
    for_each_heading(
        goal, static_cast<int>(*region.heading), kHeadings,
        [](int heading) { return radians_of(static_cast<Heading>(heading)); },
        [&](int heading) { region.headings |= 1U << static_cast<unsigned>(heading); });
  }
  goals_.push_back(region);
  asked_goals_.push_back(goal);
  return std::nullopt;
}

void CarPlanner::begin_search(const Limits& limits, SearchObserver* observer) {
  engine_->begin(start_, goals_, limits, observer);
}

void CarPlanner::assess(Plan& out) {
  drive_.clear();
  for (const Pose& pose : out.path.driven_poses()) {
    if (const auto place = lattice_->nearest(pose)) drive_.push_back(*place);
  }
  for (std::size_t i = 1; i < drive_.size(); ++i) {
    const auto move = move_between(drive_[i - 1], drive_[i]);
    if (move) out.moves.push_back(name_of(*move, free_space().map().frame()));
  }
  assert(drive_.size() == out.path.size() && out.moves.size() + 1 == drive_.size());
  out.cost = car_path_cost(*lattice_, drive_);
  out.bound = options_.bound();
  const auto reached = std::find_if(goals_.begin(), goals_.end(), [&](const CarRegion& goal) {
    return goal.contains(drive_.back());
  });
  out.start_snapping_error =
      snapping_error_between(asked_start_, lattice_->to_grid(drive_.front()));
  out.goal_snapping_error =
      snapping_error_between(asked_goals_[static_cast<std::size_t>(reached - goals_.begin())],
                             lattice_->to_grid(drive_.back()));
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

std::optional<Error> CarPlanner::do_update(std::span<const Cell> /*changed*/) {
  engine_.reset();  // its memory first
  lattice_.reset();
  std::string why_none = why_no_lattice(free_space().map(), options_.driving);
  if (!why_none.empty()) return Error{Status::unsupported_map, std::move(why_none)};
  lattice_ = std::make_shared<const CarLattice>(free_space(), options_.driving);
  make_engine();
  return fault();
}

void CarPlanner::make_engine() {
  if (lattice_) engine_ = make_car_engine(*lattice_, options_.heuristic, options_.weight);
}

}  // namespace wend
