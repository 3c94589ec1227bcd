// _core.Space: planning one path, and many; the paths of an anytime planner, one by one.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/errors.hpp"
#include "python/src/fields.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/plan.hpp"
#include "python/src/space.hpp"
#include "python/src/trace.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/request_fields.hpp"
#include "wend/session/search_run.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

/// What Python says of a request besides its ends: a planner and its options, and fields of the request by name. Those
/// that Python's functions do not name come among the options.
class Settings {
 public:
  Settings(std::string planner, const nb::dict& options, const nb::dict& fields)
      : planner_{std::move(planner)} {
    for (const auto& [name, text] : options_of(options)) {
      if (const RequestField* const field = request_field(name)) {
        fields_.take(*field, name, value_or_throw(field->info.number_of(text)));
      } else {
        planner_.options.emplace_back(name, text);
      }
    }
    fields_.take(request_fields(), fields);
  }

  const PlannerSpec& planner() const { return planner_; }

  /// Puts all but the ends into a request that has its goals.
  void put(PlanRequest& request, const FreeSpace& space) const {
    request.planner = planner_;
    fields_.put(request, space.map().frame().resolution);
  }

 private:
  PlannerSpec planner_;
  FieldValues<PlanRequest> fields_;
};

MapGoal goal_of(nb::handle goal) {
  const Coordinates at = coordinates_of(goal, "goal");
  MapGoal read;
  read.point = at.pose().point();
  if (at.has_heading) read.heading = at.pose().heading;
  return read;
}

PlanRequest request_of(nb::handle start, const nb::list& goals, const Settings& settings,
                       const FreeSpace& space) {
  PlanRequest request{coordinates_of(start, "start").pose(), {}};
  for (const nb::handle goal : goals) request.goals.push_back(goal_of(goal));
  settings.put(request, space);
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
             const nb::dict& options, const nb::dict& fields, Recording* recording, bool again) {
  const Session::View view = space.view();
  PlanRequest request = request_of(start, goals, {std::move(planner), options, fields}, view.space);
  if (recording != nullptr) {
    const PlannerInfo* const info = planners().find(request.planner.name);
    recording->on_corners = info != nullptr && info->capabilities.vertices == Vertices::corners;
  }
  request.observer = recording;
  request.explain = false;
  Interrupts interrupts;
  interrupts.watch(request.limits);
  auto answer = [&] {
    const nb::gil_scoped_release unlocked;
    return again ? space.session().replan(view, request) : space.session().plan(view, request);
  }();
  interrupts.throw_if_interrupted();
  if (!answer) raise_unexplained(space, view, std::move(request), answer.error());
  return {*std::move(answer)};
}

/// A list of Plan, or of exceptions where there is none.
nb::list plan_many(const Space& space, const nb::list& starts, const nb::list& goals,
                   std::string planner, const nb::dict& options, const nb::dict& fields,
                   unsigned threads) {
  const Settings settings(std::move(planner), options, fields);
  const FreeSpace free = space.view().space;
  Interrupts interrupts;
  std::vector<PlanRequest> requests;
  requests.reserve(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    PlanRequest& request = requests.emplace_back();
    request.start = coordinates_of(starts[i], "start").pose();
    request.goals.push_back(goal_of(goals[i]));
    settings.put(request, free);
    request.limits.cancel = &interrupts.cancelled();
    request.explain = false;
  }
  using Answers = std::vector<Expected<PlanAnswer, RequestFailure>>;
  Expected<Answers, Error> answers;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      ThreadWorkers workers(threads);
      answers = space.session().plan_all(requests, settings.planner(), workers);
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
  Solutions(const Space& space, Session::View view, PlanRequest request)
      : space_(nb::find(space)), view_(std::move(view)), request_(std::move(request)) {
    request_.explain = false;
    interrupts_.watch(request_.limits);
    auto planner = unlocked(
        [&] { return space.session().planner(request_.planner, Deadline(request_.limits)); });
    interrupts_.throw_if_interrupted();
    if (value_or_throw(std::move(planner))->anytime()) return;
    throw_failure(Status::invalid_option,
                  request_.planner.name + " is not an anytime planner: it finds one path",
                  "planner");
  }

  /// The next path; nothing after the last one. Raises NoPath if there is none at all.
  std::optional<Planned> next() {
    if (over_) return std::nullopt;
    const Space& space = nb::cast<const Space&>(space_);
    auto answer = unlocked([&] { return to_next_path(space.session()); });
    interrupts_.throw_if_interrupted();
    over_ = !answer || !*answer;
    if (!answer && is_limit(answer.error().status)) throw Failed(answer.error());
    if (!answer) raise_unexplained(space, view_, request_, answer.error());
    found_ = true;
    if (over_) return std::nullopt;
    return Planned{**std::move(answer)};
  }

 private:
  /// The limit on time begins with the first path.
  Expected<std::optional<PlanAnswer>, RequestFailure> to_next_path(Session& session) {
    if (!run_) {
      auto begun = session.begin(view_, request_);
      if (!begun) return Unexpected<RequestFailure>(std::move(begun.error()));
      run_.emplace(*std::move(begun));
    }
    auto answer = run_->next_solution();
    if (answer || found_) return answer;
    auto whole = run_->finish();
    if (!whole) return Unexpected<RequestFailure>(std::move(whole.error()));
    return *std::move(whole);
  }

  nb::object space_;  // a Space
  Session::View view_;
  PlanRequest request_;
  Interrupts interrupts_;
  std::optional<SearchRun> run_;  // nothing before the first path is asked for
  bool found_ = false;
  bool over_ = false;
};

std::unique_ptr<Solutions> solutions(const Space& space, nb::handle start, const nb::list& goals,
                                     std::string planner, const nb::dict& options,
                                     const nb::dict& fields) {
  Session::View view = space.view();
  PlanRequest request = request_of(start, goals, {std::move(planner), options, fields}, view.space);
  return std::make_unique<Solutions>(space, std::move(view), std::move(request));
}

}  // namespace

void bind_solutions(nb::module_& module) {
  module.def("request_fields", [] { return list_of(request_fields()); });
  nb::class_<Reason>(module, "Reason", "Why there is no path, not yet found out.")
      .def("text", &Reason::text);
  nb::class_<Solutions>(module, "Solutions", "The paths of an anytime planner, one by one.")
      .def("next", &Solutions::next);
}

void bind_planning(nb::class_<Space>& space) {
  space
      .def("plan", &plan, nb::arg("start").none(), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("fields"), nb::arg("recording").none(), nb::arg("again"))
      .def("solutions", &solutions, nb::arg("start").none(), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("fields"))
      .def("plan_many", &plan_many, nb::arg("starts"), nb::arg("goals"), nb::arg("planner"),
           nb::arg("options"), nb::arg("fields"), nb::arg("threads"));
}

}  // namespace wend::python
