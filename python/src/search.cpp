// search(): the common interface of a course: a list of lists in, a list of tuples out.

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <limits>
#include <span>
#include <string>

#include "python/src/bindings.hpp"
#include "python/src/cells.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/plan.hpp"
#include "python/src/registry.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

constexpr const char* kWorld = "world_state";

FreeSpace space_of(nb::handle world) {
  Planes planes;
  if (!read_rows(world, kWorld, planes)) {
    const nb::object array = nb::module_::import_("wend._arrays").attr("numbers_of")(world, kWorld);
    planes = planes_of(array, kWorld);
  }
  return unlocked([&] {
    return value_or_throw(make_free_space(
        value_or_throw(make_grid_map(std::move(planes.occupied), std::move(planes.unknown)))));
  });
}

int index_of(nb::handle pose, Py_ssize_t i, const std::string& name) {
  const nb::object item = nb::steal(PySequence_GetItem(pose.ptr(), i));
  const nb::object whole = item.is_valid() ? nb::steal(PyNumber_Index(item.ptr())) : nb::object();
  int overflow = 0;
  const long index = whole.is_valid() ? PyLong_AsLongAndOverflow(whole.ptr(), &overflow) : 0;
  if (!whole.is_valid()) {
    PyErr_Clear();
    throw_failure(Status::invalid_option, name + " must be a tuple of two integers", name);
  }
  const bool fits = overflow == 0 && index >= 0 && index <= std::numeric_limits<int>::max();
  return fits ? static_cast<int>(index) : -1;
}

/// The cell of a pose: (x, y), or (row, column).
Cell cell_of(nb::handle pose, const std::string& name, bool row_first, const FreeSpace& space) {
  if (PySequence_Check(pose.ptr()) == 0 || PySequence_Size(pose.ptr()) != 2) {
    PyErr_Clear();
    throw_failure(Status::invalid_option, name + " must be a tuple of two integers", name);
  }
  const int first = index_of(pose, 0, name);
  const int second = index_of(pose, 1, name);
  const Cell cell = row_first ? Cell{second, first} : Cell{first, second};
  if (!space.contains(cell)) {
    const bool start = name == "robot_pose";
    throw_failure(start ? Status::start_outside : Status::goal_outside,
                  name + " is outside the map, which has x from 0 to " +
                      std::to_string(space.width() - 1) + " and y from 0 to " +
                      std::to_string(space.height() - 1),
                  name);
  }
  return cell;
}

nb::list tuples_of(std::span<const Cell> cells, bool row_first) {
  nb::list tuples;
  for (const Cell cell : cells) {
    tuples.append(row_first ? nb::make_tuple(cell.y, cell.x) : nb::make_tuple(cell.x, cell.y));
  }
  return tuples;
}

/// Lengths are in cells.
Leeway leeway_of(double escape, bool closest) {
  const Leeway leeway{escape, false, {}, closest};
  if (auto fault = fault_of(leeway)) throw Failed(*std::move(fault));
  return leeway;
}

bool means_no_path(Status status) {
  return status == Status::unreachable || status == Status::start_blocked ||
         status == Status::goal_blocked || status == Status::step_limit;
}

/// "random" is the random walk, which has no diagonal steps.
PlannerSpec spec_of(const std::string& name, int connectivity, const nb::dict& options) {
  PlannerSpec spec{name == "random" ? "random_walk" : name, options_of(options)};
  const PlannerInfo* const planner = value_or_throw(planners().named("planner", spec.name));
  if (!steps_from_cell_to_cell(*planner)) {
    throw_failure(Status::invalid_option, name + " does not step from cell to cell", "planner");
  }
  if (has_option(*planner, "connectivity")) {
    spec.options.emplace_back("connectivity", std::to_string(connectivity));
  }
  return spec;
}

/// Some planners have no such option: they always step so.
void check_steps(const Planner& planner, const std::string& name, int connectivity) {
  const auto moves = planner.grid_moves();
  const int steps = moves && moves->connectivity == Connectivity::four ? 4 : 8;
  if (steps == connectivity) return;
  throw_failure(Status::invalid_option,
                name + " takes connectivity=" + std::to_string(steps) + " only", "connectivity");
}

/// A list of tuples, or None.
nb::object search(nb::handle world, nb::handle robot_pose, nb::handle goal_pose,
                  const std::string& planner, bool row_first, int connectivity, double escape,
                  bool closest, const nb::dict& options) {
  const Leeway leeway = leeway_of(escape, closest);
  const PlannerSpec spec = spec_of(planner, connectivity, options);
  const FreeSpace space = space_of(world);
  const Cell start = cell_of(robot_pose, "robot_pose", row_first, space);
  const Cell goal = cell_of(goal_pose, "goal_pose", row_first, space);
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  auto making =
      unlocked([&] { return make_planner(spec.name, space, spec.options, Deadline(limits)); });
  interrupts.throw_if_interrupted();
  const auto made = value_or_throw(std::move(making));
  check_steps(*made, planner, connectivity);
  const Units units(space.map());
  const Explainer explainer(space, units, made->grid_moves().value_or(GridMoves{}), {});
  Query query = Query::between(start, goal);
  query.limits = limits;
  Plan plan;
  Status status = Status::found;
  {
    const nb::gil_scoped_release unlocked;
    EasedQuery eased(std::move(query), *made, explainer, units, leeway);
    status = made->plan(eased.query(), plan);
    if (eased.ease_goals(status)) status = made->plan(eased.query(), plan);
    if (status == Status::found) begin_with(eased.lead(), plan, space.map().frame());
    query = eased.query();
  }
  interrupts.throw_if_interrupted();
  if (means_no_path(status)) return nb::none();
  if (status != Status::found) {
    throw_failure(status, explainer.words(made->failure(query, status), plan.metrics), "");
  }
  return tuples_of(plan.path.cells(), row_first);
}

}  // namespace

void bind_search(nb::module_& module) {
  module.def(
      "search", &search, nb::arg("world_state").none(), nb::arg("robot_pose").none(),
      nb::arg("goal_pose").none(), nb::arg("planner"), nb::arg("row_first"),
      nb::arg("connectivity"), nb::arg("escape"), nb::arg("closest"), nb::arg("options"),
      nb::sig(
          "def search(world_state: object, robot_pose: object, goal_pose: object, planner: str, "
          "row_first: bool, connectivity: int, escape: float, closest: bool, options: dict[str, "
          "str]) -> "
          "list[tuple[int, int]] | None"));
}

}  // namespace wend::python
