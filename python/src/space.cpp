// _core.Space: what is known of a map and a robot. planning.cpp has the rest of it.

#include "python/src/space.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

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
#include "python/src/fields.hpp"
#include "python/src/interrupts.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/eased_query.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

Footprint footprint_of(nb::handle given) {
  if (given.is_none()) return {};
  if (PyFloat_Check(given.ptr()) || PyLong_Check(given.ptr())) {
    return Footprint::disc(PyFloat_AsDouble(given.ptr()));
  }
  if (nb::isinstance<nb::str>(given)) {
    return value_or_throw(parse_footprint(nb::cast<std::string>(given)));
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

std::unique_ptr<Space> space_of(const GridMap& map, nb::handle footprint, const nb::dict& fields,
                                std::size_t idle_planners) {
  FreeSpaceOptions robot{.footprint = footprint_of(footprint)};
  FieldValues<FreeSpaceOptions> values;
  values.take(robot_fields(), fields);
  values.put(robot, map.frame().resolution);
  auto session = std::make_unique<Session>(
      map, std::move(robot), SessionOptions{.idle_planners = idle_planners, .hints = hints()});
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  auto view = unlocked([&] { return session->view(Deadline(limits)); });
  interrupts.throw_if_interrupted();
  return std::make_unique<Space>(std::move(session), value_or_throw(std::move(view)));
}

GridMoves moves_of(const std::string& connectivity, const std::string& corner_rule) {
  return {choice_of<Connectivity>(connectivity, "connectivity"),
          choice_of<CornerRule>(corner_rule, "corner_rule")};
}

std::shared_ptr<const CostToGo> field_of(const Space& space, const nb::list& goals,
                                         const std::string& connectivity,
                                         const std::string& corner_rule) {
  const Session::View view = space.view();
  std::vector<Cell> cells;
  for (const nb::handle goal : goals) {
    const MapPoint point = coordinates_of(goal, "goal").pose().point();
    const auto cell = cell_under(view.space, view.space.map().frame().to_grid(point));
    if (!cell) throw_failure(Status::goal_outside, "the goal is outside the map", "goal");
    cells.push_back(*cell);
  }
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  auto field = [&] {
    const nb::gil_scoped_release unlocked;
    return space.session().cost_to_go(view, std::move(cells), moves_of(connectivity, corner_rule),
                                      limits);
  }();
  interrupts.throw_if_interrupted();
  return value_or_throw(std::move(field)).costs;
}

auto cost_to_go(const Space& space, const nb::list& goals, const std::string& connectivity,
                const std::string& corner_rule) {
  const auto field = field_of(space, goals, connectivity, corner_rule);
  const auto costs = field->costs().values();
  auto copy = unlocked([&] { return std::vector<double>(costs.begin(), costs.end()); });
  return owned_array<double, 2>(std::move(copy), shape_of(field->costs()));
}

/// (dx, dy) for every cell; (0, 0) in a goal and without a path.
auto policy(const Space& space, const nb::list& goals, const std::string& connectivity,
            const std::string& corner_rule) {
  const auto field = field_of(space, goals, connectivity, corner_rule);
  std::vector<std::int8_t> steps = unlocked([&] {
    std::vector<std::int8_t> found;
    found.reserve(2 * field->costs().values().size());
    for (const Cell cell : every_cell(field->costs())) {
      const auto direction = field->policy(cell);
      const Cell to = direction ? step({0, 0}, *direction) : Cell{0, 0};
      found.insert(found.end(), {static_cast<std::int8_t>(to.x), static_cast<std::int8_t>(to.y)});
    }
    return found;
  });
  const auto [height, width] = shape_of(field->costs());
  return owned_array<std::int8_t, 3>(std::move(steps), {height, width, 2});
}

/// What Session::why_no_path() says, on one view. Nothing is said if the deadline passes.
Expected<NoPath, Error> no_path_between(const FreeSpace& space, MapPoint start, MapPoint goal,
                                        GridMoves moves, const Deadline& deadline) {
  const auto from = cell_under(space, space.map().frame().to_grid(start));
  const auto to = cell_under(space, space.map().frame().to_grid(goal));
  if (!from) return failure(Status::start_outside, "the start is outside the map", "start");
  if (!to) return failure(Status::goal_outside, "the goal is outside the map", "goal");
  return explain_no_path(space, *from, *to, moves, deadline).value_or(NoPath{});
}

nb::tuple explained(const Space& space, nb::handle start, nb::handle goal,
                    const std::string& connectivity, const std::string& corner_rule) {
  const MapPoint from = coordinates_of(start, "start").pose().point();
  const MapPoint to = coordinates_of(goal, "goal").pose().point();
  const GridMoves moves = moves_of(connectivity, corner_rule);
  const FreeSpace free = space.view().space;
  const Frame& frame = free.map().frame();
  NoPath why;
  std::string text;
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  {
    const nb::gil_scoped_release unlocked;
    const Deadline deadline(limits);
    why = value_or_throw(no_path_between(free, from, to, moves, deadline));
    const Units units(free.map());
    Explainer explainer(free, units, moves, hints());
    explainer.stop_at(deadline);
    const Status status = why.start_component == 0  ? Status::start_blocked
                          : why.goal_component == 0 ? Status::goal_blocked
                          : why.path_exists()       ? Status::found
                                                    : Status::unreachable;
    const Point start_point = frame.to_grid(from);
    const Point goal_point = frame.to_grid(to);
    const Query query{{start_point.x, start_point.y}, {Goal(goal_point)}};
    text = status == Status::found ? "there is a path"
                                   : explainer.explain(failure_in_cells(free, query, status),
                                                       ends_of(query, units), {});
  }
  interrupts.throw_if_interrupted();
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
  const FreeSpace free = space.view().space;
  const auto reason =
      free.why_blocked(free.map().frame().to_grid(coordinates_of(pose, "pose").pose()));
  if (!reason) return std::nullopt;
  return std::string(describe(*reason));
}

std::tuple<double, double, double> nearest(const Space& space, nb::handle pose) {
  const MapPose asked = coordinates_of(pose, "pose").pose();
  const nb::gil_scoped_release unlocked;
  const MapPose found = value_or_throw(space.session().nearest(asked));
  return {found.x, found.y, found.heading};
}

auto passable(const Space& space) {
  const FreeSpace free = space.view().space;
  auto cells = unlocked([&] {
    std::vector<std::uint8_t> found;
    found.reserve(free.map().size());
    for (const Cell cell : every_cell(free)) found.push_back(free.passable(cell) ? 1 : 0);
    return found;
  });
  return owned_array<std::uint8_t, 2>(std::move(cells), shape_of(free));
}

auto clearance(const Space& space) {
  const FreeSpace free = space.view().space;
  auto metres = unlocked([&] {
    std::vector<double> found;
    found.reserve(free.map().size());
    for (const Cell cell : every_cell(free)) {
      found.push_back(free.clearance(cell) * free.map().frame().resolution);
    }
    return found;
  });
  return owned_array<double, 2>(std::move(metres), shape_of(free));
}

auto costs(const Space& space) {
  const FreeSpace free = space.view().space;
  auto multipliers = unlocked([&] {
    std::vector<double> found;
    found.reserve(free.map().size());
    for (const Cell cell : every_cell(free)) found.push_back(free.terrain(cell));
    return found;
  });
  return owned_array<double, 2>(std::move(multipliers), shape_of(free));
}

}  // namespace

Hints hints() {
  return {.unknown_free = "unknown=\"free\"",
          .outside_free = "outside=\"free\"",
          .squeeze = "corner_rule=\"both\"",
          .robot_radius = "footprint=",
          .nearest = "nearest=True",
          .nearest_limit = "nearest_limit=",
          .escape = "escape=",
          .explain = "FreeSpace.explain()",
          .limit_expansions = "expansions=",
          .limit_seconds = "time_limit=",
          .limit_steps = "max_steps=",
          .turning_radius = "turning_radius=",
          .allow_reverse = "allow_reverse=True"};
}

Session::View Space::view() const {
  {
    const std::lock_guard lock(mutex_);
    if (view_) return *view_;
  }
  const nb::gil_scoped_release unlocked;  // the edit may wait for a search that looks for signals
  return value_or_throw(session_->view());
}

Expected<SpaceChange, Error> Space::edit(const MapEdit& edit, const Deadline& deadline) {
  {
    const std::lock_guard lock(mutex_);
    view_.reset();
  }
  auto change = session_->edit(edit, deadline);
  auto now = session_->view();
  const std::lock_guard lock(mutex_);
  const bool newer = now && (!view_ || view_->version < now->version);
  if (newer) view_ = *std::move(now);
  return change;
}

void bind_space(nb::module_& module) {
  nb::class_<Space> space(module, "Space", "A map with a robot.");
  bind_planning(space);
  bind_drives(space);
  bind_edits(space);
  bind_exploration(space);
  space
      .def("cost_to_go", &cost_to_go, nb::arg("goals"), nb::arg("connectivity"),
           nb::arg("corner_rule"))
      .def("policy", &policy, nb::arg("goals"), nb::arg("connectivity"), nb::arg("corner_rule"))
      .def("explain", &explained, nb::arg("start").none(), nb::arg("goal").none(),
           nb::arg("connectivity"), nb::arg("corner_rule"))
      .def("why_blocked", &why_blocked, nb::arg("pose").none())
      .def("nearest", &nearest, nb::arg("pose").none())
      .def("passable", &passable)
      .def("clearance", &clearance)
      .def("costs", &costs)
      .def_prop_ro("version", [](const Space& self) { return self.view().version; })
      .def("map", [](const Space& self) {
        const Session::View view = self.view();
        return std::tuple(view.version, view.space.map());
      });
  module.def("robot_fields", [] { return list_of(robot_fields()); });
  module.def("make_space", &space_of, nb::arg("map"), nb::arg("footprint").none(),
             nb::arg("fields"), nb::arg("idle_planners"));
}

}  // namespace wend::python
