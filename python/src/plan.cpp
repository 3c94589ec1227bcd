// _core.Plan: a path as arrays, its costs, and what can be made of it: a smoother path, a trajectory, a simulated
// drive.

#include "python/src/plan.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/metrics.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/simulation.hpp"
#include "wend/path/gears.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/session/plan_request.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

/// Refuses NaN, infinity, negative lengths, and perhaps 0.
void check_length(double metres, const char* name, bool may_be_zero) {
  if (std::isfinite(metres) && (metres > 0 || (may_be_zero && metres == 0))) return;
  throw_failure(
      Status::invalid_option,
      std::string(name) + " must be finite and " + (may_be_zero ? "at least 0" : "greater than 0"),
      name);
}

auto path_of(const Planned& plan) {
  const Frame& frame = plan.answer.space.map().frame();
  std::vector<double> numbers;
  std::size_t columns = 2;
  if (plan.path().driven()) {
    columns = 3;
    for (const Pose& pose : plan.path().poses()) {
      const MapPose at = frame.to_metres(pose);
      numbers.insert(numbers.end(), {at.x, at.y, at.heading});
    }
  } else {
    for (const MapPoint at : plan.path().points_in_metres(frame)) {
      numbers.insert(numbers.end(), {at.x, at.y});
    }
  }
  const std::size_t rows = numbers.size() / columns;
  return owned_array<double, 2>(std::move(numbers), {rows, columns});
}

/// Length in metres, points, reason.
std::optional<std::tuple<double, std::size_t, std::string>> lead_out_of(const Planned& plan) {
  const auto& lead_out = plan.answer.lead_out;
  if (!lead_out) return std::nullopt;
  return std::tuple(lead_out->length, lead_out->points, lead_out->reason);
}

auto cells_of(const Planned& plan) {
  std::vector<std::int32_t> numbers;
  for (const Point point : plan.path().points()) {
    const Cell cell = cell_at(point);
    numbers.insert(numbers.end(), {cell.x, cell.y});
  }
  const std::size_t rows = numbers.size() / 2;
  return owned_array<std::int32_t, 2>(std::move(numbers), {rows, 2});
}

auto points_of(const Planned& plan) {
  std::vector<double> numbers;
  for (const Point point : plan.path().points()) numbers.insert(numbers.end(), {point.x, point.y});
  const std::size_t rows = numbers.size() / 2;
  return owned_array<double, 2>(std::move(numbers), {rows, 2});
}

nb::list quality_of(const Planned& plan) {
  const auto metrics =
      unlocked([&] { return value_or_throw(measure(plan.path(), plan.answer.space)); });
  return numbers_of(metrics_of(metrics), plan.answer.space.map().frame().resolution);
}

Planned smoothed(const Planned& plan, std::optional<std::string> smoother,
                 std::optional<std::string_view> simplify, std::optional<double> spacing,
                 std::optional<double> max_distance, const nb::dict& options) {
  Refinement refinement{.adjacency = plan.adjacency()};
  if (smoother) refinement.smoother = SmootherChoice{*std::move(smoother), options_of(options)};
  if (simplify) {
    refinement.simplify = Simplification{};
    const std::string wrong = option_text::parse(*simplify, refinement.simplify->by, {});
    if (!wrong.empty()) throw Failed(option_text::option_error("simplify", wrong));
  }
  const double resolution = plan.answer.space.map().frame().resolution;
  if (spacing) {
    check_length(*spacing, "spacing", false);
    refinement.spacing = *spacing / resolution;
  }
  if (max_distance) {
    check_length(*max_distance, "max_distance", true);
    refinement.max_distance = *max_distance / resolution;
  }
  Planned result{plan.answer};
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  std::optional<Expected<Refined, Error>> smoother_path;
  {
    const nb::gil_scoped_release unlocked;
    // A way out is not refined.
    const auto& lead_out = plan.answer.lead_out;
    const std::size_t points = lead_out ? lead_out->points : 0;
    smoother_path =
        refined(behind_lead(plan.path(), points), plan.answer.space, refinement, Deadline(limits));
    if (lead_out && *smoother_path) {
      Path& path = (*smoother_path)->path;
      path = joined(lead_of(plan.path(), points), path);
    }
  }
  interrupts.throw_if_interrupted();
  result.answer.refined = value_or_throw(*std::move(smoother_path));
  return result;
}

Trajectory timed(const Planned& plan, const nb::dict& options,
                 std::optional<double> corner_rounding) {
  const auto limits = value_or_throw(parse_options<TrajectoryLimits>(options_of(options)));
  if (corner_rounding) check_length(*corner_rounding, "corner_rounding", true);
  const double resolution = plan.answer.space.map().frame().resolution;
  const double rounding = corner_rounding ? *corner_rounding / resolution : kCornerRounding;
  Interrupts interrupts;
  Limits while_running;
  interrupts.watch(while_running);
  auto trajectory = unlocked([&] {
    return timed_path(plan.path(), plan.answer.space, plan.adjacency(), limits, rounding,
                      Deadline(while_running));
  });
  interrupts.throw_if_interrupted();
  return value_or_throw(std::move(trajectory));
}

/// Rows of time, x, y, heading, speed and turn rate.
auto rows_of(const std::vector<TrajectoryState>& states) {
  std::vector<double> numbers;
  for (const TrajectoryState& state : states) {
    numbers.insert(numbers.end(), {state.time, state.pose.x, state.pose.y, state.pose.heading,
                                   state.speed, state.turn_rate});
  }
  return owned_array<double, 2>(std::move(numbers), {states.size(), 6});
}

auto rows_of(const Drive& drive, const Frame& frame) {
  std::vector<double> numbers;
  for (const DriveSample& sample : drive.samples) {
    const MapPose pose = frame.to_metres(sample.pose);
    numbers.insert(numbers.end(), {sample.time, pose.x, pose.y, pose.heading,
                                   sample.velocity.linear, sample.velocity.angular});
  }
  return owned_array<double, 2>(std::move(numbers), {drive.samples.size(), 6});
}

nb::dict follow(const Planned& plan, const std::optional<std::string>& controller,
                const nb::dict& options, const nb::dict& model_options,
                const nb::dict& simulation_options, const nb::dict& follower_options) {
  const std::string name = controller.value_or(std::string(default_controller(plan.path())));
  const ControllerInfo* const info = value_or_throw(controllers().named("controller", name));
  const auto made = value_or_throw(info->make(options_of(options)));
  const auto model = value_or_throw(parse_options<MotionModel>(options_of(model_options)));
  const auto simulation =
      value_or_throw(parse_options<SimulationOptions>(options_of(simulation_options)));
  const auto follower =
      value_or_throw(parse_options<FollowerOptions>(options_of(follower_options)));
  if (const auto unfit = why_unfit(*info, model)) {
    throw_failure(Status::invalid_option, *unfit, "controller");
  }
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  const Drive drive = unlocked([&] {
    return simulate(plan.answer.space, plan.path(), *made, model, simulation, follower,
                    Deadline(limits));
  });
  interrupts.throw_if_interrupted();
  if (drive.outcome == DriveOutcome::refused) {
    throw_failure(Status::invalid_option, drive.refusal, "plan");
  }
  nb::dict result;
  for (const auto& choice : choice_names(DriveOutcome{})) {
    if (choice.value == drive.outcome)
      result["outcome"] = nb::str(choice.name.data(), choice.name.size());
  }
  result["time"] = drive.time;
  result["distance"] = drive.distance;
  result["cross_track_rms"] = drive.cross_track_rms;
  result["cross_track_largest"] = drive.cross_track_largest;
  result["final_error"] = drive.final_error;
  result["final_heading_error"] = drive.final_heading_error;
  result["collisions"] = drive.collisions;
  result["samples"] = rows_of(drive, plan.answer.space.map().frame());
  return result;
}

}  // namespace

OptionValues options_of(const nb::dict& options) {
  OptionValues values;
  for (const auto [name, value] : options) {
    values.emplace_back(nb::cast<std::string>(name), nb::cast<std::string>(value));
  }
  return values;
}

void bind_plan(nb::module_& module) {
  module.def("path_metrics", [] { return fields_of(metrics_of(PathMetrics{})); });
  module.def("search_metrics", [] { return fields_of(metrics_of(SearchMetrics{})); });
  nb::class_<Planned>(module, "Plan", "A path, and what found it.")
      .def("path", &path_of)
      .def("cells", &cells_of)
      .def("points", &points_of)
      .def_prop_ro("cost", [](const Planned& plan) { return plan.answer.plan.cost; })
      .def_prop_ro("kept", [](const Planned& plan) { return plan.answer.kept; })
      .def_prop_ro("bound", [](const Planned& plan) { return plan.answer.plan.bound; })
      .def_prop_ro("length",
                   [](const Planned& plan) {
                     return plan.path().length() * plan.answer.space.map().frame().resolution;
                   })
      .def_prop_ro(
          "work",
          [](const Planned& plan) { return numbers_of(metrics_of(plan.answer.plan.metrics)); })
      .def_prop_ro("seconds", [](const Planned& plan) { return plan.answer.search_seconds; })
      .def_prop_ro("notes", [](const Planned& plan) { return plan.answer.notes; })
      .def_prop_ro("lead_out", &lead_out_of)
      .def_prop_ro("remaining", [](const Planned& plan) { return plan.answer.remaining; })
      .def_prop_ro("start_shift", [](const Planned& plan) { return plan.answer.start_shift(); })
      .def_prop_ro("goal_shift", [](const Planned& plan) { return plan.answer.goal_shift(); })
      .def_prop_ro("gears", [](const Planned& plan) { return gears_of(plan.path()); })
      .def_prop_ro("moves",
                   [](const Planned& plan) {
                     return std::vector<std::string>(plan.answer.plan.moves.begin(),
                                                     plan.answer.plan.moves.end());
                   })
      .def("map", [](const Planned& plan) { return plan.answer.space.map(); })
      .def("quality", &quality_of)
      .def("smooth", &smoothed, nb::arg("smoother").none(), nb::arg("simplify").none(),
           nb::arg("spacing").none(), nb::arg("max_distance").none(), nb::arg("options"))
      .def("trajectory", &timed, nb::arg("limits"), nb::arg("corner_rounding").none())
      .def("follow", &follow, nb::arg("controller").none(), nb::arg("options"), nb::arg("model"),
           nb::arg("simulation"), nb::arg("follower"));

  nb::class_<Trajectory>(module, "Trajectory", "A path with time stamps and speeds.")
      .def_prop_ro("duration", &Trajectory::duration)
      .def_prop_ro("length", &Trajectory::length)
      .def_prop_ro("smallest_turning_radius", &Trajectory::smallest_turning_radius)
      .def("rows",
           [](const Trajectory& trajectory, double period) {
             if (!(period > 0 && std::isfinite(period))) {
               throw_failure(Status::invalid_option, "period must be finite and greater than 0",
                             "period");
             }
             constexpr auto kMost = static_cast<double>(Trajectory::kMostSamples);
             if (!(trajectory.duration() / period < kMost - 1)) {
               throw_failure(Status::invalid_option,
                             "period is " + format_number(period) +
                                 " s: the trajectory would have " + "more than " +
                                 format_number(kMost) + " rows",
                             "period");
             }
             return rows_of(unlocked([&] { return trajectory.samples(period); }));
           })
      .def("row", [](const Trajectory& trajectory, double time) {
        if (std::isnan(time)) throw_failure(Status::invalid_option, "time is NaN", "time");
        return rows_of(std::vector{trajectory.at(time)});
      });
}

}  // namespace wend::python
