// _core.Space: planning one path, and many; the paths of an anytime planner, one by one.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/plan.hpp"
#include "python/src/space.hpp"
#include "python/src/trace.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

double not_negative(double value, const std::string& name) {
  if (!(value >= 0)) {
    throw_failure(Status::invalid_option, name + " must be at least 0", name);
  }
  return value;
}

/// What Python says of a search besides its ends.
struct SearchSettings {
  PlannerSpec planner;
  Limits limits = {};
};

SearchSettings settings_of(std::string planner, const nb::dict& options,
                           std::optional<double> time_limit,
                           std::optional<std::int64_t> expansions) {
  SearchSettings settings{{std::move(planner), options_of(options)}};
  if (time_limit) {
    settings.limits.seconds = not_negative(*time_limit, "time_limit");
  }
  if (expansions && *expansions < 0) {
    throw_failure(Status::invalid_option, "expansions must be at least 0", "expansions");
  }
  if (expansions) settings.limits.expansions = static_cast<std::uint64_t>(*expansions);
  return settings;
}

/// What Python says a query may do where the robot cannot be.
struct LeewaySettings {
  bool nearest = false;
  std::optional<double> nearest_limit;
  double escape = 0;
  bool closest = false;
};

void allow(PlanRequest& request, const LeewaySettings& leeway) {
  request.nearest = leeway.nearest;
  if (leeway.nearest_limit) {
    request.nearest_limit = not_negative(*leeway.nearest_limit, "nearest_limit");
  }
  request.escape = not_negative(leeway.escape, "escape");
  request.closest = leeway.closest;
}

MapGoal goal_of(nb::handle goal) {
  const Coordinates at = coordinates_of(goal, "goal");
  MapGoal read;
  read.point = at.pose().point();
  if (at.has_heading) read.heading = at.pose().heading;
  return read;
}

PlanRequest request_of(nb::handle start, const nb::list& goals, SearchSettings settings,
                       double tolerance, double heading_tolerance) {
  PlanRequest request{coordinates_of(start, "start").pose(), {}};
  for (const nb::handle goal : goals) request.goals.push_back(goal_of(goal));
  request.planner = std::move(settings.planner);
  request.limits = settings.limits;
  for (MapGoal& goal : request.goals) {
    goal.tolerance = not_negative(tolerance, "tolerance");
    goal.heading_tolerance = not_negative(heading_tolerance, "heading_tolerance");
  }
  return request;
}

/// Why plan() failed, found out when it is read: that may take several searches of the whole map.
class Reason {
 public:
  /// `space` is a Space.
  Reason(nb::object space, Session::View view, PlanRequest request, PlanFailure failure)
      : space_(std::move(space)),
        view_(std::move(view)),
        request_(std::move(request)),
        failure_(std::move(failure)) {}

  std::string text() const {
    const Space& space = nb::cast<const Space&>(space_);
    Interrupts interrupts;
    Limits limits;
    interrupts.watch(limits);
    std::string text;
    {
      const nb::gil_scoped_release unlocked;
      text = space.session().explain(view_, request_, failure_, Deadline(limits));
    }
    interrupts.throw_if_interrupted();
    return text;
  }

 private:
  nb::object space_;
  Session::View view_;
  PlanRequest request_;
  PlanFailure failure_;
};

/// Raises NoPath, whose reason is not yet known.
[[noreturn]] void raise_unexplained(const Space& space, const Session::View& view,
                                    PlanRequest request, const PlanFailure& failure) {
  request.observer = nullptr;
  request.limits.cancel = nullptr;
  request.limits.clock = nullptr;
  const nb::object reason =
      nb::cast(std::make_unique<Reason>(nb::find(space), view, std::move(request), failure));
  raise(exception_of(Failed(failure), reason));
}

Planned plan(const Space& space, nb::handle start, const nb::list& goals, std::string planner,
             const nb::dict& options, std::optional<double> time_limit,
             std::optional<std::int64_t> expansions, bool nearest,
             std::optional<double> nearest_limit, double escape, bool closest, double tolerance,
             double heading_tolerance, Recording* recording, std::optional<double> keep) {
  PlanRequest request =
      request_of(start, goals, settings_of(std::move(planner), options, time_limit, expansions),
                 tolerance, heading_tolerance);
  allow(request, {nearest, nearest_limit, escape, closest});
  if (recording != nullptr) {
    const PlannerInfo* const info = planners().find(request.planner.name);
    recording->on_corners = info != nullptr && info->capabilities.vertices == Vertices::corners;
  }
  request.observer = recording;
  request.explain = false;
  if (keep) request.keep = not_negative(*keep, "keep");
  const Session::View view = space.view();
  Interrupts interrupts;
  interrupts.watch(request.limits);
  auto answer = [&] {
    const nb::gil_scoped_release unlocked;
    return keep ? space.session().replan(view, request) : space.session().plan(view, request);
  }();
  interrupts.throw_if_interrupted();
  if (!answer) raise_unexplained(space, view, std::move(request), answer.error());
  return {*std::move(answer)};
}

/// A list of Plan, or of exceptions where there is none.
nb::list plan_many(const Space& space, const nb::list& starts, const nb::list& goals,
                   std::string planner, const nb::dict& options, std::optional<double> time_limit,
                   std::optional<std::int64_t> expansions, unsigned threads, bool nearest,
                   std::optional<double> nearest_limit, double escape, bool closest) {
  const SearchSettings settings = settings_of(std::move(planner), options, time_limit, expansions);
  Interrupts interrupts;
  std::vector<PlanRequest> requests;
  requests.reserve(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    PlanRequest& request = requests.emplace_back();
    request.start = coordinates_of(starts[i], "start").pose();
    request.goals.push_back(goal_of(goals[i]));
    request.limits = settings.limits;
    request.limits.cancel = &interrupts.cancelled();
    request.explain = false;
    allow(request, {nearest, nearest_limit, escape, closest});
  }
  using Answers = std::vector<Expected<PlanAnswer, RequestFailure>>;
  Expected<Answers, Error> answers;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      ThreadWorkers workers(threads);
      answers = space.session().plan_all(requests, settings.planner, workers);
    });
  }
  interrupts.throw_if_interrupted();
  nb::list plans;
  for (auto& answer : value_or_throw(std::move(answers))) {
    if (answer) {
      plans.append(nb::cast(Planned{*std::move(answer)}));
    } else {
      plans.append(exception_of(Failed(std::move(answer.error()))));
    }
  }
  return plans;
}

/// The search of an anytime planner, which goes on when its next path is asked for.
class Solutions {
 public:
  Solutions(FreeSpace space, PlanRequest request)
      : space_(std::move(space)), request_(std::move(request)) {
    interrupts_.watch(request_.limits);
    request_.on_solution = [this](const Plan& /*plan*/) { told_ = true; };
    auto made = unlocked([this] {
      return make_planner(request_.planner.name, space_, request_.planner.options,
                          Deadline(request_.limits));
    });
    interrupts_.throw_if_interrupted();
    planner_ = value_or_throw(std::move(made));
    if (!planner_->anytime()) {
      throw_failure(Status::invalid_option,
                    request_.planner.name + " is not an anytime planner: it finds one path",
                    "planner");
    }
    const Units units(space_.map());
    explainer_.emplace(space_, units, planner_->grid_moves().value_or(GridMoves{}), Hints{});
    explainer_->allow(request_.leeway());
    eased_.emplace(query_of(request_, space_.map().frame()), *planner_, *explainer_, units,
                   request_.leeway());
  }

  /// The next path; nothing after the last one. Throws Failed if there is none at all.
  std::optional<Planned> next() {
    if (over_) return std::nullopt;
    told_ = false;
    std::optional<Status> outcome;
    {
      const nb::gil_scoped_release unlocked;
      outcome = to_next_path();
    }
    interrupts_.throw_if_interrupted();
    over_ = outcome.has_value();
    if (outcome && *outcome != Status::found) {
      throw Failed(PlanFailure{
          {*outcome,
           explainer_->words(planner_->failure(eased_->query(), *outcome), plan_.metrics)},
          plan_.metrics});
    }
    if (!told_) return std::nullopt;
    return answer();
  }

 private:
  std::optional<Status> to_next_path() {
    if (begun_) return search({});
    begun_ = true;
    auto outcome = search(planner_->begin(eased_->query(), plan_));
    const bool failed = outcome && *outcome != Status::found;
    if (failed && eased_->ease_goals(*outcome)) {
      outcome = search(planner_->begin(eased_->query(), plan_));
    }
    return outcome;
  }

  std::optional<Status> search(std::optional<Status> outcome) {
    while (!outcome && !told_) outcome = planner_->step(plan_);
    return outcome;
  }

  Planned answer() const {
    EasedQuery eased = *eased_;  // each path has its own notes
    PlanAnswer answer{.space = space_, .plan = plan_, .moves = planner_->grid_moves()};
    eased.finish(answer.plan);
    answer.notes = eased.notes();
    answer.lead_out = eased.lead_out();
    if (const auto remaining = eased.remaining()) {
      answer.remaining = *remaining * space_.map().frame().resolution;
    }
    finish_path(answer, request_, eased.lead());
    return {std::move(answer)};
  }

  FreeSpace space_;
  PlanRequest request_;
  Interrupts interrupts_;
  std::unique_ptr<Planner> planner_;
  std::optional<Explainer> explainer_;
  std::optional<EasedQuery> eased_;
  Plan plan_;
  bool begun_ = false;
  bool told_ = false;
  bool over_ = false;
};

std::unique_ptr<Solutions> solutions(const Space& space, nb::handle start, const nb::list& goals,
                                     std::string planner, const nb::dict& options,
                                     std::optional<double> time_limit,
                                     std::optional<std::int64_t> expansions, bool nearest,
                                     std::optional<double> nearest_limit, double escape,
                                     bool closest, double tolerance, double heading_tolerance) {
  SearchSettings settings = settings_of(std::move(planner), options, time_limit, expansions);
  PlanRequest request = request_of(start, goals, std::move(settings), tolerance, heading_tolerance);
  allow(request, {nearest, nearest_limit, escape, closest});
  return std::make_unique<Solutions>(space.view().space, std::move(request));
}

}  // namespace

void bind_solutions(nb::module_& module) {
  nb::class_<Reason>(module, "Reason", "Why there is no path, not yet found out.")
      .def("text", &Reason::text);
  nb::class_<Solutions>(module, "Solutions", "The paths of an anytime planner, one by one.")
      .def("next", &Solutions::next);
}

void bind_planning(nb::class_<Space>& space) {
  space
      .def("plan", &plan, nb::arg("start").none(), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("time_limit").none(), nb::arg("expansions").none(),
           nb::arg("nearest"), nb::arg("nearest_limit").none(), nb::arg("escape"),
           nb::arg("closest"), nb::arg("tolerance"), nb::arg("heading_tolerance"),
           nb::arg("recording").none(), nb::arg("keep").none())
      .def("solutions", &solutions, nb::arg("start").none(), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("time_limit").none(), nb::arg("expansions").none(),
           nb::arg("nearest"), nb::arg("nearest_limit").none(), nb::arg("escape"),
           nb::arg("closest"), nb::arg("tolerance"), nb::arg("heading_tolerance"))
      .def("plan_many", &plan_many, nb::arg("starts"), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("time_limit").none(), nb::arg("expansions").none(),
           nb::arg("threads"), nb::arg("nearest"), nb::arg("nearest_limit").none(),
           nb::arg("escape"), nb::arg("closest"));
}

}  // namespace wend::python
