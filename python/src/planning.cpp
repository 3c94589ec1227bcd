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

PlanRequest request_of(nb::handle start, const nb::list& goals, const SearchSettings& settings) {
  PlanRequest request{coordinates_of(start, "start").pose(), {}, settings.planner, settings.limits};
  for (const nb::handle goal : goals) {
    const Coordinates at = coordinates_of(goal, "goal");
    MapGoal& added = request.goals.emplace_back();
    added.point = at.pose().point();
    if (at.has_heading) added.heading = at.pose().heading;
  }
  return request;
}

Planned plan(const Space& space, nb::handle start, const nb::list& goals, std::string planner,
             const nb::dict& options, std::optional<double> time_limit,
             std::optional<std::int64_t> expansions, bool nearest, double tolerance,
             double heading_tolerance, Recording* recording) {
  PlanRequest request =
      request_of(start, goals, settings_of(std::move(planner), options, time_limit, expansions));
  request.nearest = nearest;
  for (MapGoal& goal : request.goals) {
    goal.tolerance = not_negative(tolerance, "tolerance");
    goal.heading_tolerance = not_negative(heading_tolerance, "heading_tolerance");
  }
  request.observer = recording;
  Interrupts interrupts;
  interrupts.watch(request.limits);
  auto answer = [&] {
    const nb::gil_scoped_release unlocked;
    return space.session->plan(space.view, request);
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
  for (std::size_t i = 0; i < starts.size(); ++i) {
    requests.push_back(request_of(starts[i], nb::cast<nb::list>(goals[i]), settings));
    requests.back().limits.cancel = &interrupts.cancelled();
    requests.back().explain = false;
  }
  using Answers = std::vector<Expected<PlanAnswer, RequestFailure>>;
  Expected<Answers, Error> answers;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      ThreadWorkers workers(threads);
      answers = space.session->plan_all(requests, settings.planner, workers);
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
