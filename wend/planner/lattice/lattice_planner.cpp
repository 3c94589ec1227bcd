#include "wend/planner/lattice/lattice_planner.hpp"

#include <algorithm>
#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/planner/lattice/query_ends.hpp"
#include "wend/search/paged_nodes.hpp"

namespace wend {
namespace {

struct LatticeNames {
  static LatticePose place(const LatticeState& state) { return state.place; }

  static void tell_place(SearchEvent& event, const LatticeSpace& space, const LatticePose& place) {
    event.cell = space.lattice().cell_of(place.vertex);
    event.heading = space.lattice().to_grid(place).heading;
  }
  static void tell_parent(SearchEvent& event, const LatticeSpace& space, const LatticePose& place) {
    event.parent = space.lattice().cell_of(place.vertex);
    event.parent_heading = space.lattice().to_grid(place).heading;
  }
  static void append(Path& path, const LatticeSpace& space, const LatticePose& place) {
    path.drive_to(space.lattice().to_grid(place));
  }
};

using LatticeEngineOf =
    SearchEngineOf<LatticeEngine, LatticeNames, LatticeSpace, HeapFrontier<RealKey<double>>,
                   LatticePriority, DuplicateRule::keep_cheaper, ParentLinks, PagedNodes>;

bool is_finite(const Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

/// "(2.5,3.5,90deg)", in grid coordinates
std::string text_of(const Pose& pose) {
  const double degrees = std::round(degrees_from(normalized_angle(pose.heading)) * 100) / 100;
  return '(' + format_number(pose.x) + ',' + format_number(pose.y) + ',' + format_number(degrees) +
         "deg)";
}

}  // namespace

LatticePlanner::LatticePlanner(FreeSpace space, PrimitivesChooser choose_primitives,
                               const LatticeOptions& options)
    : SearchPlanner(std::move(space)),
      choose_primitives_(std::move(choose_primitives)),
      options_(options) {
  LatticePlanner::do_update({});
}

LatticePlanner::LatticePlanner(const LatticePlanner& other, FreeSpace space)
    : SearchPlanner(std::move(space)),
      choose_primitives_(other.choose_primitives_),
      options_(other.options_),
      fault_(other.fault_),
      lattice_(other.lattice_) {
  if (lattice_) fault_ = make_engine();
}

std::unique_ptr<Planner> LatticePlanner::do_clone() const {
  return std::unique_ptr<Planner>(new LatticePlanner(*this, free_space()));
}

bool LatticePlanner::fits(const LatticePose& place) const {
  return free_space().fits(lattice_->to_grid(place));
}

std::optional<Status> LatticePlanner::do_check(const Query& query) {
  if (!lattice_) return Status::unsupported_map;
  if (!std::isfinite(query.start.heading)) return Status::unsupported_query;
  if (!is_finite(query.start)) return Status::start_outside;
  const auto start = lattice_->nearest(query.start);
  if (!start) return Status::start_outside;
  if (!fits(*start)) return Status::start_blocked;
  asked_start_ = query.start;
  start_ = *start;
  goals_.clear();
  asked_goals_.clear();
  return take_goals(query, [this](const Goal& goal) { return take_goal(goal); });
}

std::optional<Status> LatticePlanner::take_goal(const Goal& goal) {
  const Pose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  if (!std::isfinite(pose.heading)) return Status::unsupported_query;
  const auto place = is_finite(pose) ? lattice_->nearest(pose) : std::nullopt;
  const PlaceGrid vertices{.offset = 0.5,
                           .spacing = lattice_->cell_of({1, 0}).x,
                           .columns = lattice_->columns(),
                           .rows = lattice_->rows()};
  LatticeGoal taken{GoalRegion(goal, place ? std::optional(place->vertex) : std::nullopt, vertices),
                    {}};
  if (taken.vertices.empty()) return Status::goal_outside;
  const auto headings = lattice_->headings();
  const auto radians_of = [&](int heading) { return headings[static_cast<std::size_t>(heading)]; };
  for_each_heading(goal, lattice_->nearest_heading(pose.heading), static_cast<int>(headings.size()),
                   radians_of,
                   [&](int heading) { taken.headings.set(static_cast<std::size_t>(heading)); });
  const bool free = taken.vertices.keep_if([&](Cell vertex) {
    for (int heading = 0; heading < static_cast<int>(headings.size()); ++heading) {
      if (taken.headings[static_cast<std::size_t>(heading)] && fits({vertex, heading})) return true;
    }
    return false;
  });
  if (!free) return Status::goal_blocked;
  goals_.push_back(taken);
  asked_goals_.push_back(goal);
  return std::nullopt;
}

void LatticePlanner::begin_search(const Limits& limits, SearchObserver* observer) {
  engine_->begin(start_, goals_, limits, observer);
}

/// The engine writes the states of the path; the segments between them are those of the steps.
void LatticePlanner::assess(Plan& out) {
  states_.assign(out.path.driven_poses().begin(), out.path.driven_poses().end());
  out.path.clear();
  out.path.drive_to(states_.front());
  out.cost = 0;
  LatticePose last = lattice_->nearest(states_.front()).value_or(start_);
  for (std::size_t i = 1; i < states_.size(); ++i) {
    const LatticePose next = lattice_->nearest(states_[i]).value_or(last);
    const LatticeStep* const step = lattice_->step_between(last, next);
    const Cell cell = lattice_->cell_of(last.vertex);
    out.cost += lattice_->cost(last.vertex, *step);
    for (const Pose& pose : step->poses) {
      out.path.drive_to({cell.x + pose.x, cell.y + pose.y, pose.heading});
    }
    last = next;
  }
  const auto poses = out.path.driven_poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Segment segment = segment_between(poses[i - 1], poses[i]);
    out.moves.push_back(name_of(segment, free_space().map().frame()));
  }
  out.bound = options_.bound();
  const auto reached =
      std::ranges::find_if(goals_, [&](const LatticeGoal& goal) { return goal.contains(last); });
  const auto index = static_cast<std::size_t>(reached - goals_.begin());
  out.start_snapping_error = snapping_error_between(asked_start_, lattice_->to_grid(start_));
  out.goal_snapping_error = snapping_error_between(asked_goals_[index], lattice_->to_grid(last));
}

std::string LatticePlanner::do_reason(const Query& query, Status status) const {
  if (status == Status::unsupported_map) return fault_ ? fault_->message : std::string();
  if (status == Status::unsupported_query) {
    return query.goals.empty() ? "the query has no goal"
                               : "the headings of the start and the goal must be finite numbers";
  }
  if (!lattice_) return {};
  const auto blocked = [&](const std::string& name, const Pose& pose) {
    const auto place = lattice_->nearest(pose);
    if (!place) return std::string();
    const Pose taken = lattice_->to_grid(*place);
    const auto reason = free_space().why_blocked(taken);
    return "the robot does not fit at the " + name + " " + text_of(taken) + " of the lattice" +
           (reason ? ": " + std::string(describe(*reason)) : "");
  };
  const auto pose_of = [](const Goal& goal) {
    return Pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  };
  if (status == Status::start_blocked) return blocked("start", query.start);
  if (query.goals.empty()) return {};
  if (status == Status::goal_blocked) return blocked("goal", pose_of(query.goals.front()));
  if (status != Status::unreachable) return {};
  return "no sequence of motion primitives leads from the start " + text_of(query.start) +
         " to the goal " + text_of(pose_of(query.goals.front())) + ", in cells";
}

double LatticePlanner::do_heuristic(const Pose& pose) const {
  if (!lattice_ || !is_finite(pose)) return 0;
  const auto place = lattice_->nearest(pose);
  return place ? engine_->heuristic(*place) : 0;
}

std::uint64_t LatticePlanner::do_state_count() const {
  return lattice_ ? free_space().possible().count() * lattice_->headings().size() : 0;
}

std::optional<Error> LatticePlanner::do_update(std::span<const Cell> /*changed*/) {
  engine_.reset();  // its memory first
  lattice_.reset();
  fault_ = prepare();
  return fault_;
}

std::optional<Error> LatticePlanner::prepare() {
  auto primitives = choose_primitives_(free_space());
  if (!primitives) return std::move(primitives.error());
  std::string why_none = MotionLattice::why_none(free_space().map(), *primitives);
  if (!why_none.empty()) return Error{Status::unsupported_map, std::move(why_none)};
  lattice_ = std::make_shared<const MotionLattice>(free_space(), *primitives, options_.costs);
  return make_engine();
}

std::optional<Error> LatticePlanner::make_engine() {
  const auto heuristic = options_.weight == 0 ? LatticeHeuristic::zero : options_.heuristic;
  engine_ = std::make_unique<LatticeEngineOf>(
      LatticeSpace(*lattice_), LatticePriority(*lattice_, heuristic, options_.weight));
  return no_memory_for("the robot");
}

}  // namespace wend
