// _core.Space: what is known of a map and a robot. planning.cpp has the rest of it.

#include "python/src/space.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/cells.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "wend/geometry/direction.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

Footprint footprint_of(nb::handle given) {
  if (given.is_none()) return {};
  if (PyFloat_Check(given.ptr()) || PyLong_Check(given.ptr())) {
    return Footprint::disc(PyFloat_AsDouble(given.ptr()));
  }
  std::vector<Point> corners;
  for (const nb::handle corner : given) {
    const MapPose at =
        coordinates_of(corner, "footprint[" + std::to_string(corners.size()) + "]").pose();
    corners.push_back({at.x, at.y});
  }
  return value_or_throw(Footprint::polygon(value_or_throw(Polygon::make(std::move(corners)))));
}

template <class Enum>
Enum choice_of(const std::string& text, const std::string& name) {
  Enum value{};
  const std::string wrong = option_text::parse(text, value, {});
  if (!wrong.empty()) throw Failed(option_text::option_error(name, wrong));
  return value;
}

/// UnknownPolicy or OutsidePolicy, by the name of its argument.
template <class Policy>
Policy policy_of(const std::string& text, const std::string& name) {
  if (text == "blocked") return Policy::blocked;
  if (text == "free") return Policy::free;
  throw Failed(
      option_text::option_error(name, option_text::unknown_choice(text, {"blocked", "free"})));
}

Hints hints() {
  return {.unknown_free = "unknown=\"free\"",
          .outside_free = "outside=\"free\"",
          .squeeze = "corner_rule=\"both\"",
          .robot_radius = "footprint=",
          .nearest = "nearest=True",
          .explain = "FreeSpace.explain()",
          .limit_expansions = "expansions=",
          .limit_seconds = "time_limit=",
          .limit_steps = "max_steps="};
}

Space space_of(const GridMap& map, nb::handle footprint, const std::string& unknown,
               const std::optional<std::string>& outside, double clearance_distance,
               double clearance_cost, std::size_t idle_planners) {
  FreeSpaceOptions robot{.footprint = footprint_of(footprint),
                         .unknown = policy_of<UnknownPolicy>(unknown, "unknown"),
                         .clearance_distance = clearance_distance,
                         .clearance_cost = clearance_cost};
  if (outside) robot.outside = policy_of<OutsidePolicy>(*outside, "outside");
  const nb::gil_scoped_release unlocked;
  auto session = std::make_unique<Session>(
      map, std::move(robot), SessionOptions{.idle_planners = idle_planners, .hints = hints()});
  Session::View view = value_or_throw(session->view());
  return {std::move(session), std::move(view)};
}

GridMoves moves_of(const std::string& connectivity, const std::string& corner_rule) {
  return {choice_of<Connectivity>(connectivity, "connectivity"),
          choice_of<CornerRule>(corner_rule, "corner_rule")};
}

std::shared_ptr<const CostToGo> field_of(const Space& space, const nb::list& goals,
                                         const std::string& connectivity,
                                         const std::string& corner_rule) {
  std::vector<Cell> cells;
  for (const nb::handle goal : goals) {
    const MapPoint point = coordinates_of(goal, "goal").pose().point();
    const auto cell = cell_under(space.free(), space.frame().to_grid(point));
    if (!cell) throw_failure(Status::goal_outside, "the goal is outside the map", "goal");
    cells.push_back(*cell);
  }
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  auto field = [&] {
    const nb::gil_scoped_release unlocked;
    return space.session->cost_to_go(space.view, std::move(cells),
                                     moves_of(connectivity, corner_rule), limits);
  }();
  interrupts.throw_if_interrupted();
  return value_or_throw(std::move(field)).costs;
}

auto cost_to_go(const Space& space, const nb::list& goals, const std::string& connectivity,
                const std::string& corner_rule) {
  const auto field = field_of(space, goals, connectivity, corner_rule);
  const auto costs = field->costs().values();
  return owned_array<double, 2>({costs.begin(), costs.end()}, shape_of(space.free()));
}

/// (dx, dy) for every cell; (0, 0) in a goal and without a path.
auto policy(const Space& space, const nb::list& goals, const std::string& connectivity,
            const std::string& corner_rule) {
  const auto field = field_of(space, goals, connectivity, corner_rule);
  std::vector<std::int8_t> steps;
  for (const Cell cell : every_cell(space.free())) {
    const auto direction = field->policy(cell);
    const Cell to = direction ? step({0, 0}, *direction) : Cell{0, 0};
    steps.insert(steps.end(), {static_cast<std::int8_t>(to.x), static_cast<std::int8_t>(to.y)});
  }
  const auto [height, width] = shape_of(space.free());
  return owned_array<std::int8_t, 3>(std::move(steps), {height, width, 2});
}

nb::tuple explained(const Space& space, nb::handle start, nb::handle goal,
                    const std::string& connectivity, const std::string& corner_rule) {
  const MapPoint from = coordinates_of(start, "start").pose().point();
  const MapPoint to = coordinates_of(goal, "goal").pose().point();
  const GridMoves moves = moves_of(connectivity, corner_rule);
  const Frame& frame = space.frame();
  NoPath why;
  std::string text;
  {
    const nb::gil_scoped_release unlocked;
    why = value_or_throw(space.session->why_no_path(from, to, moves));
    const Units units(space.free().map());
    const Explainer explainer(space.free(), units, moves, hints());
    const Status status = why.start_component == 0  ? Status::start_blocked
                          : why.goal_component == 0 ? Status::goal_blocked
                          : why.path_exists()       ? Status::found
                                                    : Status::unreachable;
    const Ends ends{units.place("start", frame.to_grid(from)),
                    {units.place("goal", frame.to_grid(to))}};
    text = status == Status::found ? "there is a path" : explainer.explain(status, ends, {}, {});
  }
  nb::list ways;
  for (const Way& way : why.ways) {
    const MapPoint narrowest = frame.to_metres(way.widest.narrowest);
    ways.append(nb::make_tuple(way.unknown_free, way.squeeze, way.smaller_robot,
                               way.widest.radius * frame.resolution,
                               nb::make_tuple(narrowest.x, narrowest.y)));
  }
  return nb::make_tuple(text, why.start_component, why.goal_component, why.path_exists(), ways);
}

std::optional<std::string> why_blocked(const Space& space, nb::handle pose) {
  const auto reason =
      space.free().why_blocked(space.frame().to_grid(coordinates_of(pose, "pose").pose()));
  if (!reason) return std::nullopt;
  return std::string(describe(*reason));
}

std::tuple<double, double, double> nearest(const Space& space, nb::handle pose) {
  const MapPose asked = coordinates_of(pose, "pose").pose();
  const nb::gil_scoped_release unlocked;
  const MapPose found = value_or_throw(space.session->nearest(asked));
  return {found.x, found.y, found.heading};
}

auto passable(const Space& space) {
  std::vector<std::uint8_t> cells;
  cells.reserve(space.free().map().size());
  for (const Cell cell : every_cell(space.free()))
    cells.push_back(space.free().passable(cell) ? 1 : 0);
  return owned_array<std::uint8_t, 2>(std::move(cells), shape_of(space.free()));
}

auto clearance(const Space& space) {
  std::vector<double> metres;
  metres.reserve(space.free().map().size());
  for (const Cell cell : every_cell(space.free())) {
    metres.push_back(space.free().clearance(cell) * space.frame().resolution);
  }
  return owned_array<double, 2>(std::move(metres), shape_of(space.free()));
}

}  // namespace

void bind_space(nb::module_& module) {
  nb::class_<Space> space(module, "Space", "A map with a robot.");
  bind_planning(space);
  space
      .def("cost_to_go", &cost_to_go, nb::arg("goals"), nb::arg("connectivity"),
           nb::arg("corner_rule"))
      .def("policy", &policy, nb::arg("goals"), nb::arg("connectivity"), nb::arg("corner_rule"))
      .def("explain", &explained, nb::arg("start").none(), nb::arg("goal").none(),
           nb::arg("connectivity"), nb::arg("corner_rule"))
      .def("why_blocked", &why_blocked, nb::arg("pose").none())
      .def("nearest", &nearest, nb::arg("pose").none())
      .def("passable", &passable)
      .def("clearance", &clearance);
  module.def("make_space", &space_of, nb::arg("map"), nb::arg("footprint").none(),
             nb::arg("unknown"), nb::arg("outside").none(), nb::arg("clearance_distance"),
             nb::arg("clearance_cost"), nb::arg("idle_planners"));
}

}  // namespace wend::python
