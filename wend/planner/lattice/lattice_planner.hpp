#pragma once

// LatticePlanner: a planner for the poses of a lattice. It checks queries, runs a search on the lattice, and
// says what the path that it found is worth. The planners `car` and `lattice` differ in their lattices and in the
// functions of lattice_engine.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/planner/lattice/query_ends.hpp"
#include "wend/planner/lattice/rest_on_lattice.hpp"
#include "wend/planner/search_planner.hpp"
#include "wend/robot/nearest_passable.hpp"
#include "wend/space/lattice/lattice_pose.hpp"

namespace wend {

/// What makes a planner of a kind of lattice.
template <class Lattice>
struct LatticeParts {
  /// The lattice for a space, or why there is none: also if the deadline passes before. Called again for another space.
  std::function<Expected<Lattice, Error>(const FreeSpace&, DeadlineCheck&)> make_lattice;
  /// A search on it; not allocated() without memory for its nodes.
  std::function<std::unique_ptr<LatticeEngine<Lattice>>(const Lattice&)> make_engine;
  std::string robot;  // whose poses they are, in errors: "the car"
  double bound = 1;   // Plan::bound of every answer, unless the engine has one
};

template <class Lattice>
class LatticePlanner final : public SearchPlanner<LatticeEngine<Lattice>> {
 public:
  LatticePlanner(FreeSpace space, LatticeParts<Lattice> parts,
                 DeadlineCheck& stop = DeadlineCheck::never())
      : LatticePlanner(std::move(space), std::move(parts), nullptr) {
    prepare(stop);
  }

  /// Why it cannot plan in its space, if it cannot.
  const std::optional<Error>& fault() const { return fault_; }

 private:
  using Place = typename Lattice::Place;
  using PlaceGoal = LatticeGoal<Place>;
  using SearchPlanner<LatticeEngine<Lattice>>::engine_;

  LatticePlanner(FreeSpace space, LatticeParts<Lattice> parts,
                 std::shared_ptr<const Lattice> lattice)
      : SearchPlanner<LatticeEngine<Lattice>>(std::move(space)),
        parts_(std::move(parts)),
        lattice_(std::move(lattice)) {
    if (lattice_) fault_ = make_engine();
  }

  std::unique_ptr<Planner> do_clone() const override {
    auto clone =
        std::unique_ptr<LatticePlanner>(new LatticePlanner(this->free_space(), parts_, lattice_));
    if (!lattice_) clone->fault_ = fault_;
    return clone;
  }

  std::optional<Error> do_update(const SpaceChange& /*change*/) override {
    LatticePlanner::do_release();  // its memory first
    prepare(DeadlineCheck::never());
    return fault_;
  }

  void prepare(DeadlineCheck& stop) {
    auto lattice = parts_.make_lattice(this->free_space(), stop);
    if (lattice) {
      lattice_ = std::make_shared<const Lattice>(*std::move(lattice));
      fault_ = make_engine();
    } else {
      fault_ = std::move(lattice.error());
    }
  }

  void do_release() override {
    engine_.reset();
    lattice_.reset();
  }

  std::optional<Error> make_engine() {
    engine_ = parts_.make_engine(*lattice_);
    return this->no_memory_for(parts_.robot);
  }

  std::optional<Status> do_check(const Query& query) override {
    if (!lattice_) return Status::unsupported_map;
    if (!std::isfinite(query.start.heading)) return Status::unsupported_query;
    const auto start = lattice_->place_on(query.start);
    if (!start) return Status::start_outside;
    if (!lattice_->may_stand(*start)) return Status::start_blocked;
    asked_start_ = query.start;
    start_ = *start;
    goals_.clear();
    asked_goals_.clear();
    return take_goals(query, [this](const Goal& goal) { return take_goal(goal); });
  }

  std::optional<Status> take_goal(const Goal& goal) {
    if (goal.heading && !std::isfinite(*goal.heading)) return Status::unsupported_query;
    PlaceGoal taken = places_of(goal);
    Status why = taken.vertices.empty() ? Status::goal_outside : Status::goal_blocked;
    const bool reachable = taken.vertices.keep_if([&](Cell vertex) {
      if (!lattice_->may_stand(vertex, taken.headings)) return false;
      why = Status::unreachable;
      return lattice_->connected(start_.vertex, vertex);
    });
    if (!reachable) return why;
    goals_.push_back(taken);
    asked_goals_.push_back(goal);
    return std::nullopt;
  }

  /// The places of a goal, free or not.
  PlaceGoal places_of(const Goal& goal) const {
    const Pose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
    const auto place = lattice_->place_on(pose);
    PlaceGoal places{
        GoalRegion(goal, place ? std::optional(place->vertex) : std::nullopt, vertices()), {}};
    take_headings(goal, places);
    return places;
  }

  PlaceGrid vertices() const {
    return {.offset = Lattice::kVertexOffset,
            .spacing = lattice_->cell_of({1, 0}).x,
            .columns = lattice_->columns(),
            .rows = lattice_->rows()};
  }

  void take_headings(const Goal& goal, PlaceGoal& taken) const {
    const std::span<const double> headings = lattice_->headings();
    for_each_heading(
        goal, lattice_->nearest_heading(goal.heading.value_or(0)),
        static_cast<int>(headings.size()),
        [&](int heading) { return headings[static_cast<std::size_t>(heading)]; },
        [&](int heading) { taken.headings.set(static_cast<std::size_t>(heading)); });
    taken.any_heading = taken.headings.count() == headings.size();
  }

  std::optional<Point> do_nearest_free(const Goal& goal) const override {
    if (!lattice_ || !is_near_a_map(goal)) return std::nullopt;
    PlaceGoal taken = places_of(goal);
    const auto is_free = [&](Cell vertex) { return lattice_->may_stand(vertex, taken.headings); };
    if (taken.vertices.keep_if(is_free)) return goal.point;
    const PlaceGrid grid = vertices();
    const auto vertex =
        nearest_accepted(grid.columns, grid.rows, grid.nearest(goal.point), is_free);
    if (!vertex) return std::nullopt;
    return grid.point(*vertex);
  }

  std::optional<Plan> do_rest_of(const Path& path, const Query& query,
                                 std::size_t& passed) const override {
    if (!lattice_ || !path.driven()) return std::nullopt;
    const auto place = place_on_path(path.driven_poses(), query.start, passed);
    if (!place) return std::nullopt;
    auto rest = rest_on(*lattice_, path.driven_poses(), *place);
    if (!rest) return std::nullopt;
    passed = place->joint;
    rest->start_snapping_error = {place->distance, place->turn};
    return rest;
  }

  std::optional<Pose> do_place_of(const Pose& pose) const override {
    if (!lattice_ || !is_near_a_map(Goal(pose))) return std::nullopt;
    const auto place = lattice_->place_on(pose);
    if (!place) return std::nullopt;
    return lattice_->to_grid(*place);
  }

  std::vector<LeavingMotion> do_motions_from(const Pose& from, double /*most*/) const override {
    const auto place = lattice_ ? lattice_->place_on(from) : std::nullopt;
    return place ? leaving_motions(*lattice_, *place) : std::vector<LeavingMotion>();
  }

  /// The pose at which a plan from this start would begin, if it is on the path; else the nearest one, if it is near.
  std::optional<PlaceOnDrive> place_on_path(std::span<const Pose> poses, const Pose& start,
                                            std::size_t passed) const {
    if (const auto taken = lattice_->place_on(start)) {
      const Pose begin = lattice_->to_grid(*taken);
      const auto ahead = poses.subspan(std::min(passed, poses.size() - 1));
      const auto found = std::ranges::find(ahead, begin);
      if (found != ahead.end()) {
        const SnappingError error = snapping_error_between(start, begin);
        const auto joint = static_cast<std::size_t>(found - ahead.begin());
        return PlaceOnDrive{joint + (poses.size() - ahead.size()), 0, begin, error.distance,
                            error.turn};
      }
    }
    constexpr double kMostTurn = 0.4;  // radians, between the robot and the path
    const PlaceOnDrive nearest = nearest_on_drive(JoinedPoses(poses), start, passed);
    const double most = farthest_from_path(this->free_space().map().frame());
    if (nearest.distance > most || nearest.turn > kMostTurn) return std::nullopt;
    return nearest;
  }

  void begin_search(const Limits& limits, SearchObserver* observer) override {
    engine_->begin(start_, goals_, limits, observer);
  }

  void assess(Plan& out) override {
    places_.clear();
    for (const Pose& pose : out.path.driven_poses()) {
      if (const auto place = lattice_->nearest(pose)) places_.push_back(*place);
    }
    write_drive(*lattice_, places_, out);
    out.bound = engine_->bound().value_or(parts_.bound);
    const Place& last = places_.back();
    const auto reached =
        std::ranges::find_if(goals_, [&](const PlaceGoal& goal) { return goal.contains(last); });
    const auto index = static_cast<std::size_t>(reached - goals_.begin());
    out.start_snapping_error = snapping_error_between(asked_start_, lattice_->to_grid(start_));
    out.goal_snapping_error = snapping_error_between(asked_goals_[index], lattice_->to_grid(last));
  }

  std::vector<FailureCause> do_failure(const Query& query, Status status) const override {
    if (!lattice_) return {OwnText{fault_ ? fault_->message : std::string()}};
    switch (status) {
      case Status::unsupported_query:
        return {
            wrong_heading(query, std::numeric_limits<double>::max(), InvalidQuery::Fault::heading)};
      case Status::start_outside:
        return {EndOutside{}};
      case Status::start_blocked:
        return {why_no_place({}, Goal(query.start)).value_or(EndBlocked{})};
      case Status::goal_outside:
      case Status::goal_blocked:
        return causes_of_goals(query,
                               [&](std::size_t i) { return why_no_place(i, query.goals[i]); });
      case Status::unreachable:
        if (!may_leave(query.start)) return {NoMotion{}};
        return causes_of_goals(query,
                               [&](std::size_t i) { return why_no_motion(i, query.goals[i]); });
      default:
        return {};
    }
  }

  /// Nothing if the robot may stand somewhere at this end.
  std::optional<FailureCause> why_no_place(EndIndex end, const Goal& goal) const {
    PlaceGoal taken = places_of(goal);
    if (taken.vertices.keep_if(
            [&](Cell vertex) { return lattice_->may_stand(vertex, taken.headings); })) {
      return std::nullopt;
    }
    const auto place = lattice_->place_on({goal.point.x, goal.point.y, goal.heading.value_or(0)});
    if (!place) return EndOutside{end};
    auto cause = why_blocked(*lattice_, end, *place);
    if (cause) cause = at_headings(*std::move(cause), goal, this->free_space());
    return cause;
  }

  bool may_leave(const Pose& start) const {
    const auto place = lattice_->place_on(start);
    return place && can_leave(*lattice_, *place);
  }

  /// Nothing if motions lead to a goal where the robot may stand.
  std::optional<FailureCause> why_no_motion(std::size_t index, const Goal& goal) const {
    if (auto cause = why_no_place(index, goal)) return cause;
    const PlaceGoal taken = places_of(goal);
    bool any = false;
    taken.vertices.for_each([&](Cell vertex) {
      for (std::size_t heading = 0; heading < lattice_->headings().size() && !any; ++heading) {
        if (!taken.headings[heading]) continue;
        const Place place{vertex, static_cast<decltype(Place::heading)>(heading)};
        any = lattice_->may_stand(place) && can_arrive(*lattice_, place);
      }
    });
    return any ? std::nullopt : std::optional<FailureCause>(NoMotion{index});
  }

  double do_heuristic(const Pose& pose) const override {
    const auto place = lattice_ ? lattice_->place_on(pose) : std::nullopt;
    return place ? engine_->heuristic(*place) : 0;
  }

  std::uint64_t do_state_count() const override {
    return lattice_ ? lattice_->possible_poses() : 0;
  }
  std::optional<GridMoves> do_grid_moves() const override { return std::nullopt; }
  PlaceGrid do_place_grid() const override {
    return lattice_ ? vertices() : cells_of(this->free_space());
  }

  LatticeParts<Lattice> parts_;
  std::optional<Error> fault_;
  // Clones share it. Null in a space that has none; then there is no engine either.
  std::shared_ptr<const Lattice> lattice_;
  // Of the query that was checked last.
  Pose asked_start_;
  Place start_;
  std::vector<PlaceGoal> goals_;
  std::vector<Goal> asked_goals_;  // one for each of goals_
  std::vector<Place> places_;      // of the path
};

}  // namespace wend
