// The planners, smoothers and controllers as dictionaries, and indexes. The only place that reads the fields of a
// PlannerInfo.

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

#include "python/src/bindings.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/registry.hpp"
#include "python/src/space.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/control/controller.hpp"
#include "wend/io/files.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

nb::str str_of(std::string_view text) { return nb::str(text.data(), text.size()); }

template <class Enum>
nb::str name_of(Enum value) {
  for (const auto& choice : choice_names(Enum{})) {
    if (choice.value == value) return str_of(choice.name);
  }
  return nb::str("");
}

nb::list options_of(const std::vector<OptionInfo>& options) {
  nb::list list;
  for (const OptionInfo& option : options) {
    nb::list choices;
    for (const std::string& choice : option.choices) choices.append(str_of(choice));
    nb::dict entry;
    entry["name"] = str_of(option.name);
    entry["kind"] = str_of(to_string(option.kind));
    entry["default"] = str_of(option.default_value);
    entry["choices"] = nb::tuple(choices);
    entry["least"] = option.least;
    entry["greatest"] = option.greatest;
    entry["help"] = str_of(option.help);
    list.append(entry);
  }
  return list;
}

nb::list planners_list() {
  nb::list list;
  for (const PlannerInfo& planner : planners()) {
    nb::dict entry;
    entry["name"] = str_of(planner.name);
    entry["summary"] = str_of(planner.summary);
    entry["idea"] = str_of(planner.idea);
    entry["paper"] = str_of(planner.citation);
    entry["guarantee"] = name_of(planner.guarantee);
    entry["guarantee_text"] = str_of(planner.guarantee_text);
    entry["time"] = str_of(planner.time);
    entry["memory"] = str_of(planner.memory);
    entry["when"] = str_of(planner.when);
    entry["terrain"] = planner.capabilities.terrain;
    entry["any_angle"] = planner.capabilities.any_angle;
    entry["headings"] = planner.capabilities.headings;
    entry["preprocessing"] = name_of(planner.preprocessing);
    entry["needs_index"] = planner.index_support != nullptr;
    entry["options"] = options_of(planner.options);
    list.append(entry);
  }
  return list;
}

nb::list smoothers_list() {
  nb::list list;
  for (const SmootherInfo& smoother : smoothers()) {
    nb::dict entry;
    entry["name"] = str_of(smoother.name);
    entry["summary"] = str_of(smoother.summary);
    entry["paper"] = str_of(smoother.citation);
    entry["options"] = options_of(smoother.options);
    list.append(entry);
  }
  return list;
}

nb::list controllers_list() {
  nb::list list;
  for (const ControllerInfo& controller : controllers()) {
    nb::dict entry;
    entry["name"] = str_of(controller.name);
    entry["summary"] = str_of(controller.summary);
    entry["idea"] = str_of(controller.idea);
    entry["paper"] = str_of(controller.citation);
    entry["options"] = options_of(controller.options);
    list.append(entry);
  }
  return list;
}

/// The bytes of an index, and the planner that reads them.
struct Index {
  std::string planner;
  IndexBytes bytes;
};

constexpr double kLeastProgress = 0.005;  // between two calls of Python

/// Passes the share of an index that is built on to a function of Python, or to None. It may be called on any thread
/// without the interpreter lock.
std::function<void(double)> teller_of(nb::handle tell) {
  if (tell.is_none()) return {};
  return [tell, told = -1.0](double share) mutable {
    if (share < told + kLeastProgress && share < 1) return;
    told = share;
    const nb::gil_scoped_acquire locked;
    try {
      tell(share);
    } catch (nb::python_error& error) {
      error.discard_as_unraisable(tell);
    }
  };
}

Index built_index(const Space& space, const std::string& planner, unsigned threads,
                  nb::handle tell) {
  const PlannerInfo* const info = value_or_throw(planners().named("planner", planner));
  if (!info->index_support) {
    throw_failure(Status::invalid_option, planner + " does not use an index", "planner");
  }
  const std::function<void(double)> progress = teller_of(tell);
  const FreeSpace free = space.view().space;
  Interrupts interrupts;
  Expected<IndexBytes, Error> bytes;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      ThreadWorkers workers(threads);
      IndexBuilding building;
      building.workers = &workers;
      building.cancel = &interrupts.cancelled();
      building.progress = progress;
      bytes = info->index_support->build(free, building);
    });
  }
  interrupts.throw_if_interrupted();
  return {planner, value_or_throw(std::move(bytes))};
}

Index opened_index(const std::filesystem::path& file) {
  const nb::gil_scoped_release unlocked;
  IndexBytes bytes = value_or_throw(open_index(file));
  auto header = read_index_header(bytes.bytes());
  if (!header) {
    header.error().message = file.string() + ": " + header.error().message;
    header.error().where = file.string();
  }
  return {std::string(value_or_throw(std::move(header)).planner_name()), std::move(bytes)};
}

}  // namespace

bool steps_from_cell_to_cell(const PlannerInfo& planner) {
  return !planner.capabilities.headings && !planner.capabilities.any_angle;
}

bool has_option(const PlannerInfo& planner, std::string_view name) {
  return std::ranges::any_of(planner.options,
                             [&](const OptionInfo& option) { return option.name == name; });
}

void bind_registry(nb::module_& module) {
  module.def("planners", &planners_list);
  module.def("smoothers", &smoothers_list);
  module.def("controllers", &controllers_list);
  module.def("trajectory_limits", [] { return options_of(option_schema<TrajectoryLimits>()); });

  nb::class_<Index>(module, "Index", "What a planner with an index computed for a map and a robot.")
      .def_ro("planner", &Index::planner)
      .def_prop_ro("size", [](const Index& index) { return index.bytes.size(); })
      .def("save",
           [](const Index& index, const std::filesystem::path& file) {
             const nb::gil_scoped_release unlocked;
             value_or_throw(write_index(file, index.bytes));
           })
      .def("give_to", [](const Index& index, const Space& space) {
        space.session().set_index(index.planner, index.bytes);
      });
  module.def("build_index", &built_index, nb::arg("space"), nb::arg("planner"), nb::arg("threads"),
             nb::arg("tell").none());
  module.def("open_index", &opened_index, nb::arg("file"));
}

}  // namespace wend::python
