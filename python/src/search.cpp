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
#include "wend/session/session.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

constexpr const char* kWorld = "world_state";

GridMap map_of(nb::handle world) {
  Planes planes;
  if (!read_rows(world, kWorld, planes)) {
    const nb::object array = nb::module_::import_("wend._arrays").attr("numbers_of")(world, kWorld);
    planes = planes_of(array, kWorld);
  }
  return unlocked([&] {
    return value_or_throw(make_grid_map(std::move(planes.occupied), std::move(planes.unknown)));
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
Cell cell_of(nb::handle pose, const std::string& name, bool row_first, const GridMap& map) {
  if (PySequence_Check(pose.ptr()) == 0 || PySequence_Size(pose.ptr()) != 2) {
    PyErr_Clear();
    throw_failure(Status::invalid_option, name + " must be a tuple of two integers", name);
  }
  const int first = index_of(pose, 0, name);
  const int second = index_of(pose, 1, name);
  const Cell cell = row_first ? Cell{second, first} : Cell{first, second};
  if (!map.contains(cell)) {
    const bool start = name == "robot_pose";
    throw_failure(start ? Status::start_outside : Status::goal_outside,
                  name + " is outside the map, which has x from 0 to " +
                      std::to_string(map.width() - 1) + " and y from 0 to " +
                      std::to_string(map.height() - 1),
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
  PlanRequest request{.planner = spec_of(planner, connectivity, options),
                      .escape = escape,
                      .closest = closest,
                      .explain = false,
                      .coordinates = MapUnits::cells};
  if (auto fault = fault_of(request.leeway())) throw Failed(*std::move(fault));
  GridMap map = map_of(world);
  const Query query = Query::between(cell_of(robot_pose, "robot_pose", row_first, map),
                                     cell_of(goal_pose, "goal_pose", row_first, map));
  const Point goal = query.goals.front().point;
  request.start = {query.start.x, query.start.y, 0};
  request.goals = {{.point = {goal.x, goal.y}}};
  Interrupts interrupts;
  interrupts.watch(request.limits);
  Session session(std::move(map));
  auto run = unlocked([&] { return session.begin(request); });
  interrupts.throw_if_interrupted();
  if (!run) throw Failed(Error(std::move(run.error())));
  check_steps(run->planner(), planner, connectivity);
  auto answer = unlocked([&] { return run->finish(); });
  interrupts.throw_if_interrupted();
  if (answer) return tuples_of(answer->path().cells(), row_first);
  if (means_no_path(answer.error().status)) return nb::none();
  throw Failed(Error(std::move(answer.error())));
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
