#include "wend/tour/stop_costs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/mutex.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/units.hpp"

namespace wend {
namespace {

/// The first error of tasks that run at the same time.
class FirstError {
 public:
  void keep(Error error) {
    const MutexLock lock(mutex_);
    if (!error_) error_ = std::move(error);
  }
  bool any() {
    const MutexLock lock(mutex_);
    return error_.has_value();
  }
  std::optional<Error> take() { return std::move(error_); }

 private:
  Mutex mutex_;
  std::optional<Error> error_;
};

Error stopped(const Deadline& deadline) {
  return {deadline.status(), "the costs between stops were not all found: " + deadline.text(), {}};
}

class StopCostSearch {
 public:
  StopCostSearch(Session& session, const Session::View& view, std::span<const MapPose> stops,
                 const StopCostOptions& options)
      : session_(session),
        space_(view.space),
        options_(options),
        deadline_(options.limits),
        workers_(options.workers != nullptr ? *options.workers : one_),
        found_{CostMatrix(static_cast<int>(stops.size())), {}} {
    for (const MapPose& stop : stops) stops_.push_back(space_.map().frame().to_grid(stop));
  }

  Expected<StopCosts, Error> run() {
    const PlannerInfo* info = planners().find(options_.planner.name);
    auto made = session_.planners(options_.planner, workers_.count(), deadline_);
    if (!made) return Unexpected<Error>(made.error());
    std::vector<WarmPlanner> warm = *std::move(made);
    const auto moves = warm.front()->grid_moves();
    const bool headings = info != nullptr && info->capabilities.headings;
    const bool indexed = info != nullptr && info->index_support != nullptr;
    const bool by_steps = moves && info != nullptr && !info->capabilities.any_angle && !indexed;
    if (auto fault = fault_of_stops(headings, moves.value_or(GridMoves{}))) {
      return Unexpected<Error>(std::move(*fault));
    }
    if (by_steps) {
      fill_from_fields(*moves);
    } else {
      fill_by_queries(warm, indexed, headings);
    }
    if (auto error = error_.take()) return Unexpected<Error>(std::move(*error));
    find_cut_off();
    return std::move(found_);
  }

 private:
  std::string name_of(std::size_t stop) const {
    const bool named = stop < options_.names.size() && !options_.names[stop].empty();
    return named ? options_.names[stop] : "stop " + std::to_string(stop);
  }

  static Cell cell_of(const Pose& pose) {
    return {static_cast<int>(std::floor(pose.x)), static_cast<int>(std::floor(pose.y))};
  }

  std::optional<Error> fault_of_stops(bool headings, GridMoves moves) const {
    const Units units(space_.map());
    const Explainer explainer(space_, units, moves, {});
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      const Pose& stop = stops_[i];
      if (!std::isfinite(stop.x) || !std::isfinite(stop.y) || !std::isfinite(stop.heading)) {
        return Error{Status::unsupported_query, name_of(i) + " is not finite", name_of(i)};
      }
      const Place place = units.place(name_of(i), stop.point());
      if (!space_.contains(place.cell)) {
        return Error{Status::start_outside, explainer.outside(place), name_of(i)};
      }
      if (headings) continue;  // its planner knows whether the robot fits
      if (std::string text = explainer.blocked(place); !text.empty()) {
        return Error{Status::start_blocked, std::move(text), name_of(i)};
      }
    }
    return std::nullopt;
  }

  /// Costs are those to the goal of a field.
  void fill_from_fields(GridMoves moves) {
    workers_.run(stops_.size(), [&](std::size_t goal, unsigned /*worker*/) {
      if (error_.any()) return;
      const std::vector<Cell> goals{cell_of(stops_[goal])};
      const auto field = CostToGo::make(space_, goals, moves, deadline_.left());
      if (!field) return error_.keep(error_of(field.error().status, goal));
      for (std::size_t from = 0; from < stops_.size(); ++from) {
        set(from, goal, field->cost(cell_of(stops_[from])));
      }
    });
  }

  /// Ways between cells cost the same both ways for planners with an index.
  void fill_by_queries(std::vector<WarmPlanner>& warm, bool both_ways, bool headings) {
    workers_.run(stops_.size(), [&](std::size_t from, unsigned worker) {
      Plan plan;
      for (std::size_t to = both_ways ? from + 1 : 0; to < stops_.size(); ++to) {
        if (to == from) continue;
        if (error_.any()) return;
        Query query{stops_[from], {}, {}};
        query.goals.push_back(headings ? Goal(stops_[to]) : Goal(stops_[to].point()));
        if (!both_ways || to % kQueriesBetweenClockReads == 0) query.limits = deadline_.left();
        const Status status = warm[worker]->plan(query, plan);
        if (status != Status::found && status != Status::unreachable) {
          return error_.keep(error_of(status, status == Status::goal_blocked ? to : from));
        }
        const double cost = status == Status::found ? plan.cost : CostMatrix::kNoWay;
        set(from, to, cost);
        if (both_ways) set(to, from, cost);
      }
    });
  }

  Error error_of(Status status, std::size_t stop) const {
    if (status == Status::time_limit || status == Status::cancelled) return stopped(deadline_);
    return {status == Status::goal_blocked ? Status::start_blocked : status,
            name_of(stop) + ": " + std::string(describe(status)), name_of(stop)};
  }

  void set(std::size_t from, std::size_t to, double cost) {
    if (from == to) return;
    found_.costs.set(static_cast<int>(from), static_cast<int>(to), cost);
  }

  /// The stops that no path joins, both ways, to the one that is joined to most.
  void find_cut_off() {
    const int count = found_.costs.size();
    const auto joined = [&](int a, int b) {
      return std::max(found_.costs(a, b), found_.costs(b, a)) < CostMatrix::kNoWay;
    };
    int middle = 0;
    int most = 0;
    for (int stop = 0; stop < count; ++stop) {
      int others = 0;
      for (int other = 0; other < count; ++other) others += static_cast<int>(joined(stop, other));
      if (others > most) middle = stop;
      most = std::max(most, others);
    }
    for (int stop = 0; stop < count; ++stop) {
      if (!joined(stop, middle)) found_.cut_off.push_back(stop);
    }
  }

  static constexpr std::size_t kQueriesBetweenClockReads = 16;

  Session& session_;
  const FreeSpace& space_;
  const StopCostOptions& options_;
  Deadline deadline_;
  OneWorker one_;
  Workers& workers_;
  std::vector<Pose> stops_;  // in grid coordinates
  StopCosts found_;
  FirstError error_;
};

}  // namespace

Expected<StopCosts, Error> stop_costs(Session& session, const Session::View& view,
                                      std::span<const MapPose> stops,
                                      const StopCostOptions& options) {
  return StopCostSearch(session, view, stops, options).run();
}

std::string cut_off_text(const StopCosts& costs) {
  if (costs.cut_off.empty()) return {};
  constexpr std::size_t kMostTold = 5;
  std::string text = costs.cut_off.size() == 1 ? "stop " : "stops ";
  for (std::size_t i = 0; i < std::min(costs.cut_off.size(), kMostTold); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(costs.cut_off[i]);
  }
  if (costs.cut_off.size() > kMostTold) {
    text += " and " + std::to_string(costs.cut_off.size() - kMostTold) + " more";
  }
  const bool one = costs.cut_off.size() == 1;
  return text + (one ? " is cut off: no path joins it to most of the others"
                     : " are cut off: no paths join them to most of the others");
}

}  // namespace wend
