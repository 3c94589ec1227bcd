// _core.Space: planning one path, and many.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/plan.hpp"
#include "python/src/space.hpp"
#include "python/src/trace.hpp"
#include "wend/base/thread_workers.hpp"

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

MapGoal goal_of(nb::handle goal) {
  const Coordinates at = coordinates_of(goal, "goal");
  MapGoal read;
  read.point = at.pose().point();
  if (at.has_heading) read.heading = at.pose().heading;
  return read;
}

Planned plan(const Space& space, nb::handle start, const nb::list& goals, std::string planner,
             const nb::dict& options, std::optional<double> time_limit,
             std::optional<std::int64_t> expansions, bool nearest, double tolerance,
             double heading_tolerance, Recording* recording) {
  SearchSettings settings = settings_of(std::move(planner), options, time_limit, expansions);
  PlanRequest request{coordinates_of(start, "start").pose(), {}};
  for (const nb::handle goal : goals) request.goals.push_back(goal_of(goal));
  request.planner = std::move(settings.planner);
  request.limits = settings.limits;
  request.nearest = nearest;
  for (MapGoal& goal : request.goals) {
    goal.tolerance = not_negative(tolerance, "tolerance");
    goal.heading_tolerance = not_negative(heading_tolerance, "heading_tolerance");
  }
  request.observer = recording;
  const Session::View view = space.view();
  Interrupts interrupts;
  interrupts.watch(request.limits);
  auto answer = [&] {
    const nb::gil_scoped_release unlocked;
    return space.session().plan(view, request);
  }();
  interrupts.throw_if_interrupted();
  return {value_or_throw(std::move(answer))};
}

/// A list of Plan, or of exceptions where there is none.
nb::list plan_many(const Space& space, const nb::list& starts, const nb::list& goals,
                   std::string planner, const nb::dict& options, std::optional<double> time_limit,
                   std::optional<std::int64_t> expansions, unsigned threads) {
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

}  // namespace

void bind_planning(nb::class_<Space>& space) {
  space
      .def("plan", &plan, nb::arg("start").none(), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("time_limit").none(), nb::arg("expansions").none(),
           nb::arg("nearest"), nb::arg("tolerance"), nb::arg("heading_tolerance"),
           nb::arg("recording").none())
      .def("plan_many", &plan_many, nb::arg("starts"), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("time_limit").none(), nb::arg("expansions").none(),
           nb::arg("threads"));
}

}  // namespace wend::python
