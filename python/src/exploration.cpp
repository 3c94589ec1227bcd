// _core.Space: a robot that drives over the map without knowing it.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cstdint>
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
#include "wend/base/thread_time.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/session/failure_text.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

Cell cell_of(const FreeSpace& space, nb::handle point, const std::string& name) {
  const Frame& frame = space.map().frame();
  const auto cell = cell_under(space, frame.to_grid(coordinates_of(point, name).pose().point()));
  if (!cell) {
    throw_failure(name == "start" ? Status::start_outside : Status::goal_outside,
                  "the " + name + " is outside the map", name);
  }
  return *cell;
}

ReplanWhen when_of(const std::string& text) {
  ReplanWhen when{};
  const std::string wrong = option_text::parse(text, when, {});
  if (!wrong.empty()) throw Failed(option_text::option_error("replan", wrong));
  return when;
}

nb::dict result_of(const Explorer& explorer, Status status) {
  std::vector<std::int32_t> cells;
  for (const Cell cell : explorer.driven()) cells.insert(cells.end(), {cell.x, cell.y});
  const ExplorationTotals& totals = explorer.totals();
  nb::dict result;
  result["status"] = std::string(to_string(status));
  result["reason"] = words_of(explorer.failure(), explorer.believed(), hints());
  result["cells"] = owned_array<std::int32_t, 2>(std::move(cells), {explorer.driven().size(), 2});
  result["cost"] = explorer.driven_cost();
  result["plans"] = totals.replans;
  result["expanded"] = totals.expanded;
  result["first_seconds"] = totals.first_seconds;
  result["planning_seconds"] = totals.planning_seconds;
  result["worst_seconds"] = totals.worst_seconds;
  result["known"] = explorer.believed().map();
  return result;
}

nb::dict explore(const Space& space, nb::handle start, nb::handle goal, std::string planner,
                 const nb::dict& options, std::optional<double> sensor_range,
                 std::optional<GridMap> known, const std::string& replan, double keep) {
  const FreeSpace truth = space.view().space;
  const Frame& frame = truth.map().frame();
  constexpr double kMetres = 5;
  constexpr double kCells = 30;
  ExplorerOptions chosen{.robot = truth.options(), .known = std::move(known)};
  chosen.sensor_range =
      sensor_range.value_or(frame.metric ? kMetres : kCells * frame.resolution) / frame.resolution;
  chosen.planner = {std::move(planner), options_of(options)};
  chosen.when = when_of(replan);
  chosen.keep = keep;
  chosen.clock = thread_cpu_seconds;
  Interrupts interrupts;
  interrupts.watch(chosen.limits);  // each search looks
  const Cell from = cell_of(truth, start, "start");
  const Cell to = cell_of(truth, goal, "goal");
  std::optional<Expected<Explorer, Error>> explorer;
  std::optional<Status> end;
  {
    const nb::gil_scoped_release unlocked;
    explorer.emplace(Explorer::make(truth.map(), from, to, chosen));
    while (*explorer && !end && !interrupts.cancelled()) {
      chosen.limits.clock();  // a step may plan nothing
      end = (*explorer)->step();
    }
  }
  interrupts.throw_if_interrupted();
  if (!*explorer) throw Failed(explorer->error());
  return result_of(**explorer, *end);
}

}  // namespace

void bind_exploration(nb::class_<Space>& space) {
  space.def("explore", &explore, nb::arg("start").none(), nb::arg("goal").none(),
            nb::arg("planner"), nb::arg("options"), nb::arg("sensor_range").none(),
            nb::arg("known").none(), nb::arg("replan"), nb::arg("keep"));
}

}  // namespace wend::python
